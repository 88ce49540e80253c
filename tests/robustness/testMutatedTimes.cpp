// Hundreds of damaged time folders: no crash, no hang. Each is read, or refused with its file and the array, entry or
// line in question. Each is read in a process of its own.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "base/atomicFile.hpp"
#include "io/sampleState.hpp"
#include "io/stateFiles.hpp"
#include "io/uniformTime.hpp"
#include "robustness/child.hpp"
#include "robustness/mutations.hpp"

using namespace pfem;
using namespace pfem::test;
namespace fs = std::filesystem;

namespace {

/// `signedAnew`: the checksum is made right again, so that the reader itself is tried.
void tryFolders(bool signedAnew) {
    const TemporaryFolder folder;
    const fs::path time = folder.path() / "1";
    writeState(time, sampleState());
    const std::vector<std::string> files{"fluid.vtu", "solid.vtu", "boundary.vtu", "uniform/time"};
    std::map<std::string, std::string> original;
    for (const auto& file : files) original[file] = readText(time / file);
    const int n = countOf("PFEM_MUTATIONS", 40) * 6;
    int used = 0;
    for (int seed = 0; seed < n && !testing::Test::HasFailure(); ++seed) {
        Mutator mutator(5000 + static_cast<unsigned>(seed));
        const std::string& file = files[static_cast<std::size_t>(seed) % (signedAnew ? 3 : 4)];
        for (const auto& [name, content] : original) std::ofstream(time / name, std::ios::binary) << content;
        const std::string damaged =
            file == "uniform/time" ? mutator.text(original[file]) : mutator.bytes(original[file]);
        std::ofstream(time / file, std::ios::binary) << damaged;
        if (signedAnew) {
            UniformTime uniform = readUniformTime(time);
            uniform.checksums[file] = checksumOf(damaged);
            std::ofstream(time / "uniform/time") << formatUniformTime(uniform, "1");
        }
        const Outcome outcome = inChild([&] { readState<2>(time); });
        const auto about = [&] {
            return file + ", seed " + std::to_string(seed) + "\n" + outcome.text.substr(0, 3000);
        };
        EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << " " << about();
        EXPECT_EQ(outcome.text.find("error of the program"), std::string::npos) << about();
        used += outcome.code == 0;
        if (outcome.code == 1) {
            static const std::regex named("(array|entry) ['\"]|[A-Za-z]\"? array|(at| from|and) line [0-9]+");
            EXPECT_NE(outcome.text.find("file: " + time.string()), std::string::npos) << "no file: " << about();
            EXPECT_TRUE(std::regex_search(outcome.text, named)) << "neither array nor entry nor line: " << about();
        }
        if (!signedAnew && file != "uniform/time" && damaged != original[file]) {
            EXPECT_EQ(outcome.code, 1) << "damage is not noticed: " << about();
        }
        if (const char* keep = std::getenv("PFEM_KEEP"); keep != nullptr && testing::Test::HasFailure())
            std::ofstream(keep, std::ios::binary) << damaged;
    }
    std::cout << n << " damaged folders, " << used << " usable, " << n - used << " refused\n";
}

TEST(MutatedTimeFolders, areRefusedByTheirChecksum) { tryFolders(false); }

TEST(MutatedTimeFolders, withRightChecksumsAreReadOrRefused) { tryFolders(true); }

}  // namespace
