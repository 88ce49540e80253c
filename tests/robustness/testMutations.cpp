// Hundreds of damaged dictionaries: no crash, no hang. Each is used, with a warning where a word has no effect, or
// refused with its file and line. Each is read in a process of its own.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "base/atomicFile.hpp"
#include "case/timeControl.hpp"
#include "functions/functionObjects.hpp"
#include "io/sampleState.hpp"
#include "io/stateFiles.hpp"
#include "mesher/mesher.hpp"
#include "mesher/readMeshDict.hpp"
#include "reference/keywords.hpp"
#include "robustness/child.hpp"
#include "robustness/mutations.hpp"
#include "solver/courantRate.hpp"
#include "solver/recorder.hpp"
#include "solver/setup.hpp"

using namespace pfem;
using namespace pfem::test;
namespace fs = std::filesystem;

namespace {

std::set<std::string> wordsOf(const std::string& text) {
    std::set<std::string> words;
    static const std::regex word("[A-Za-z_][A-Za-z0-9_]*");
    for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) words.insert(it->str());
    return words;
}

/// Keys that no program knows, of all sub-dictionaries but those that `log` calls unused as a whole.
void unknownKeys(const Dictionary& dict, const std::set<std::string>& known, const std::string& log,
                 std::vector<std::string>& found) {
    for (const auto& key : dict.keys()) {
        if (known.count(key) == 0)
            found.push_back(key);
        else if (dict.isDict(key) && log.find("entry '" + key + "' in ") == std::string::npos)
            unknownKeys(dict.subDict(key), known, log, found);
    }
}

/// The first tutorial, coarse; its dictionaries can be replaced one at a time.
class MutatedDictionaries : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        for (const char* name : {"constant", "system"})
            fs::copy(fs::path(PFEM_SOURCE_DIR) / "tutorials/damBreakElasticWall" / name, folder_.path() / name,
                     fs::copy_options::recursive);
        mesh();
    }

    void mesh() const {  // as pfemMesh
        const Dictionary dict = Dictionary::read(folder_.path() / "system/meshDict");
        const auto state = buildMesh(readMeshDict(dict, {"water", "rubber"}, 0.02)).state;
        warnUnused(dict, std::cerr);
        writeState(folder_.path() / "0", state);
    }

    /// As pfemFsiFoam: read all, then one step.
    void step() const {
        const Case theCase(folder_.path());
        TimeControl clock(theCase);
        State<2> start = readState<2>(clock.startFolder());
        auto problem = readProblem<2>(theCase, start);
        Simulation<2> simulation{std::move(problem), readControls(theCase), std::move(start),
                                 [&](const TimeInfo& time, double dt) { return clock.advance(time, dt); }};
        const State<2>& state = simulation.state;
        FunctionObjects<2> functions(theCase, clock.dictionary(), clock.startName());
        warnUnused(clock.dictionary(), std::cerr);
        Recorder<2> recorder(theCase, clock, simulation);
        recorder.start(clock.deltaT(state.time));
        functions.start(state);
        recorder.step(clock.deltaT(state.time, {.courant = courantRate(state).largest}));
        functions.execute(state);
        recorder.save();
        fs::remove_all(clock.folder(state.time));
    }

    TemporaryFolder folder_;
};

TEST_P(MutatedDictionaries, areUsedOrRefusedWithTheirLine) {
    const fs::path file = folder_.path() / GetParam();
    const std::string original = readText(file);
    const std::string bare = std::regex_replace(original, std::regex("/\\*[^]*?\\*/|//[^\n]*"), "");
    const bool meshToo = file.filename() == "meshDict";
    const auto use = [&] {
        if (meshToo) mesh();
        step();
    };
    std::set<std::string> known = wordsOf(keywordPage() + original);
    known.insert("libs");
    const std::regex place(folder_.path().string() + "/(system|constant)/[A-Za-z]+( (at|from) line |:)[0-9]+");
    const int n = countOf("PFEM_MUTATIONS", 40);

    const Outcome sound = inChild(use);
    ASSERT_EQ(sound.code, 0) << sound.text;
    EXPECT_EQ(sound.text, "");
    int used = 0, warned = 0, failed = 0;
    for (int seed = 0; seed < n && !HasFailure(); ++seed) {
        const std::string text = Mutator(1000 + static_cast<unsigned>(seed)).text(seed % 4 == 0 ? original : bare);
        std::ofstream(file, std::ios::binary) << text;
        const Outcome outcome = inChild(use);
        const auto about = [&] {
            return std::string(GetParam()) + ", seed " + std::to_string(seed) + ", code " +
                   std::to_string(outcome.code) + "\n" + outcome.text.substr(0, 3000) + "\n" + text.substr(0, 3000);
        };
        EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << about();
        EXPECT_EQ(outcome.text.find("error of the program"), std::string::npos) << about();
        if (outcome.code == 1) {
            EXPECT_TRUE(std::regex_search(outcome.text, place)) << "file and line are missing: " << about();
            failed += outcome.text.find("FOAM FATAL ERROR") != std::string::npos;
        } else if (outcome.code == 0) {
            ++used;
            warned += outcome.text.find("Warning") != std::string::npos;
            std::vector<std::string> unknown;
            unknownKeys(Dictionary::read(file), known, outcome.text, unknown);
            for (const auto& key : unknown)
                EXPECT_TRUE(outcome.text.find("'" + key + "'") != std::string::npos ||
                            text.find("$" + key) != std::string::npos)
                    << "no warning of '" << key << "': " << about();
        }
    }
    std::cout << GetParam() << ": " << n << " damaged, " << used << " used (" << warned << " with a warning), "
              << n - used << " refused, " << failed << " of them after the first step had failed\n";
}

INSTANTIATE_TEST_SUITE_P(, MutatedDictionaries,
                         testing::Values("system/controlDict", "system/meshDict", "system/pfemSolution",
                                         "constant/materials", "constant/boundaryConditions", "constant/g"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

}  // namespace
