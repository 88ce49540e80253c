// Hundreds of damaged dictionaries and time folders: no crash, no hang; what is refused is refused with the file and,
// in a dictionary, the line. Each is read in a process of its own.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>

#include "base/error.hpp"
#include "case/controlDict.hpp"
#include "io/atomicFile.hpp"
#include "io/sampleState.hpp"
#include "io/stateFiles.hpp"
#include "io/uniformTime.hpp"
#include "mesher/mesher.hpp"
#include "mesher/readMeshDict.hpp"
#include "mutations.hpp"
#include "solver/advance.hpp"
#include "solver/setup.hpp"

using namespace pfem;
using namespace pfem::test;
namespace fs = std::filesystem;

namespace {

int countOf(const char* variable, int standard) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::atoi(text) : standard;
}

enum Outcome { good = 0, refused = 1, withoutPlace = 2, otherError = 3 };

/// What `body` did in a child process: an Outcome, or -signal (SIGALRM: it took more than ten seconds).
int outcome(const std::function<void()>& body, std::string& message) {
    int pipes[2];
    if (pipe(pipes) != 0) throw InternalError("pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(pipes[0]);
        std::cout.setstate(std::ios::failbit);
        std::cerr.setstate(std::ios::failbit);
        alarm(10);
        int code = good;
        std::string text;
        try {
            body();
        } catch (const UserError& error) {
            code = error.where().file.empty() ? withoutPlace : refused;
            text = error.where().file + ":" + std::to_string(error.where().line) + ": " + error.what();
        } catch (const StepFailure& error) {  // parsed, but physics that cannot be computed
            code = refused;
            text = error.what();
        } catch (const std::exception& error) {
            code = otherError;
            text = error.what();
        }
        const auto written = write(pipes[1], text.data(), std::min<std::size_t>(text.size(), 4000));
        _exit(written < 0 ? otherError : code);
    }
    close(pipes[1]);
    message.clear();
    char buffer[512];
    for (ssize_t n; (n = read(pipes[0], buffer, sizeof buffer)) > 0;) message.append(buffer, static_cast<std::size_t>(n));
    close(pipes[0]);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

/// The first tutorial, coarse; its dictionaries can be replaced one at a time.
class MutatedDictionaries : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        fs::copy(fs::path(PFEM_SOURCE_DIR) / "tutorials/damBreakElasticWall/constant", folder_.path() / "constant",
                 fs::copy_options::recursive);
        fs::copy(fs::path(PFEM_SOURCE_DIR) / "tutorials/damBreakElasticWall/system", folder_.path() / "system",
                 fs::copy_options::recursive);
        state_ = mesh();
    }
    State<2> mesh() const {
        const Dictionary dict = Dictionary::read(folder_.path() / "system/meshDict");
        return buildMesh(readMeshDict(dict, {"water", "rubber"}, 0.02)).state;
    }
    /// As the programs do: read all, then one step.
    void use(bool meshToo) {
        State<2> state = meshToo ? mesh() : state_;
        const Case theCase(folder_.path());
        readControlDict(Dictionary::read(theCase.controlDict()));
        const auto problem = readProblem<2>(theCase, state);
        const auto controls = readControls(theCase);
        advance<2>(problem, controls, state, 1e-4);
    }
    TemporaryFolder folder_;
    State<2> state_;
};

TEST_P(MutatedDictionaries, areUsedOrRefusedWithTheirLine) {
    const fs::path file = folder_.path() / GetParam();
    const std::string original = readText(file);
    const bool meshToo = file.filename() == "meshDict";
    const int n = countOf("PFEM_MUTATIONS", 34);
    std::map<int, int> counts;
    std::string message;
    ASSERT_EQ(outcome([&] { use(meshToo); }, message), good) << message;
    for (int seed = 0; seed < n; ++seed) {
        const std::string text = Mutator(1000 + static_cast<unsigned>(seed)).text(original);
        std::ofstream(file, std::ios::binary) << text;
        const int code = outcome([&] { use(meshToo); }, message);
        ++counts[code];
        EXPECT_TRUE(code == good || code == refused) << GetParam() << ", seed " << seed << ": outcome " << code << "\n"
                                                     << message << "\n" << text.substr(0, 3000);
        if (HasFailure()) break;
    }
    std::cout << GetParam() << ": " << n << " damaged, " << counts[good] << " usable, " << counts[refused] << " refused\n";
}

INSTANTIATE_TEST_SUITE_P(, MutatedDictionaries,
                         testing::Values("system/controlDict", "system/meshDict", "system/pfemSolution",
                                         "constant/materials", "constant/boundaryConditions", "constant/g"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

/// Files of a time folder. `signedAnew`: the checksum is made right again, so that the reader itself is tried.
void tryFolders(bool signedAnew) {
    const TemporaryFolder folder;
    const fs::path time = folder.path() / "1";
    writeState(time, sampleState());
    const std::vector<std::string> files{"fluid.vtu", "solid.vtu", "boundary.vtu", "uniform/time"};
    std::map<std::string, std::string> original;
    for (const auto& file : files) original[file] = readText(time / file);
    const int n = countOf("PFEM_MUTATIONS", 34) * 6;
    std::map<int, int> counts;
    for (int seed = 0; seed < n; ++seed) {
        Mutator mutator(5000 + static_cast<unsigned>(seed));
        const std::string& file = files[static_cast<std::size_t>(seed) % (signedAnew ? 3 : 4)];
        for (const auto& [name, content] : original) std::ofstream(time / name, std::ios::binary) << content;
        std::string damaged = file == "uniform/time" ? mutator.text(original[file]) : mutator.bytes(original[file]);
        std::ofstream(time / file, std::ios::binary) << damaged;
        if (signedAnew) {
            UniformTime uniform = readUniformTime(time);
            uniform.checksums[file] = checksumOf(damaged);
            std::ofstream(time / "uniform/time") << formatUniformTime(uniform, "1");
        }
        std::string message;
        const int code = outcome([&] { readState<2>(time); }, message);
        ++counts[code];
        EXPECT_TRUE(code == good || code == refused) << file << ", seed " << seed << ": outcome " << code << "\n" << message;
        if (!signedAnew && file != "uniform/time" && damaged != original[file]) {
            EXPECT_EQ(code, refused) << file << ", seed " << seed << ": damage is not noticed";
        }
        if (testing::Test::HasFailure()) {
            if (const char* keep = std::getenv("PFEM_KEEP")) std::ofstream(keep, std::ios::binary) << damaged;
            break;
        }
    }
    std::cout << n << " damaged folders, " << counts[good] << " usable, " << counts[refused] << " refused\n";
}

TEST(MutatedTimeFolders, areRefusedByTheirChecksum) {
    tryFolders(false);
}

TEST(MutatedTimeFolders, withRightChecksumsAreReadOrRefused) {
    tryFolders(true);
}

}  // namespace
