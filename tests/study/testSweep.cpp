#include "study/sweepPlot.hpp"

#include "sweepCase.hpp"

namespace pfem {
namespace {

using test::parameters;
using test::tip;

const std::string stiffness = R"(stiffness { file "constant/materials"; entry "rubber/E"; values (1e6 2e6); } )";

class Sweeps : public test::SweepFolder {
protected:
    /// The message of checkSweep, or of reading.
    std::string checked(const std::string& text) const {
        return complaint([&] { checkSweep(Case(root), sweepOf(text)); });
    }
};

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST_F(Sweeps, makesCasesOfTheirOwn) {
    const auto sweep =
        sweepOf("method grid;" + tip + parameters(stiffness + "size { file common; entry h; values (1 2 4); }"));
    checkSweep(Case(root), sweep);
    const auto cases = sweepCases(sweep, root / "sweep");
    ASSERT_EQ(cases.size(), 6u);
    EXPECT_EQ(cases[5].root, root / "sweep/6");
    for (const auto& one : cases) makeSweepCase(Case(root), sweep, one, Copying::keep);
    EXPECT_EQ(of(cases[4], "constant/materials").subDict("rubber").get<double>("E"), 2e6);
    EXPECT_EQ(of(cases[4], "system/meshDict").get<double>("meshSize"), 2);
    EXPECT_EQ(casesTable(sweep, {cases[0], cases[5]}), "case,stiffness,size\n1,1e6,1\n6,2e6,4\n");
}

TEST_F(Sweeps, tableOfFinishedAndUnfinishedCases) {
    const auto sweep = sweepOf(
        "method grid; results { most { function tip; column D_y; } end { function tip; column D_x; value last; } }" +
        parameters(stiffness + R"(words { file "constant/g"; entry value; values ("a,b"); })"));
    const auto cases = sweepCases(sweep, root / "sweep");
    for (const auto& one : cases) {
        makeSweepCase(Case(root), sweep, one, Copying::keep);
        put("sweep/" + std::to_string(one.number) + "/postProcessing/tip/0/D",
            "# Probe 0 (0 0 0)\n# Time\n0 (0 0 0)\n1 (3 5 0)\n2 (1 4 0)\n");
    }
    addTime(cases[0].root, "2");
    addTime(cases[1].root, "1");
    const auto rows = gather(sweep, cases);
    EXPECT_EQ(resultsTable(sweep, rows),
              "case,stiffness,words,most,end,state\n1,1e6,\"a,b\",5,1,finished\n2,2e6,\"a,b\",,,unfinished\n");
    const std::string script = sweepPlot(sweep, rows);
    EXPECT_SAYS(script, "1000000 0 5 1 \n2000000 0 NaN NaN \n");
    EXPECT_SAYS(script, "layout 2,2");
    EXPECT_SAYS(script, "set xtics (\"'a,b'\" 0)");
}

TEST_F(Sweeps, entryThatIsNotThere) {
    const std::string text = checked("method grid;" + tip +
                                     parameters(R"(a { file "constant/materials"; entry "ruber/E"; values (1 2); })"));
    EXPECT_SAYS(text, "sweepDict:");
    EXPECT_SAYS(text, "has no entry 'ruber/E' (did you mean 'rubber/E'?)");
    EXPECT_SAYS(text, "steel/E");
    EXPECT_SAYS(
        checked("method grid;" + tip + parameters(R"(a { file "constant/material"; entry E0; values (1 2); })")),
        "did you mean 'constant/materials'?");
    EXPECT_SAYS(checked("method grid;" + tip + parameters(R"(a { file "system/meshDict"; entry h; values (1 2); })")),
                "which that includes");
    EXPECT_SAYS(checked("method grid; results { tip { function tap; } }" + parameters(stiffness)), "tip");
}

TEST_F(Sweeps, wrongWords) {
    EXPECT_SAYS(checked("method lattice;" + tip + parameters(stiffness)), "latinHypercube");
    EXPECT_SAYS(checked("method grid;" + tip), "no 'parameters'");
    EXPECT_SAYS(checked("method grid; results { }" + parameters(stiffness)), "'results' is empty");
    EXPECT_SAYS(checked("method grid;" + tip + parameters("a { file f; entry e; }")), "either values");
    EXPECT_SAYS(checked("method grid;" + tip + parameters("a { file f; entry e; values (1); range (1 2); }")),
                "either values");
    EXPECT_SAYS(checked("method grid;" + tip + parameters("a { file f; entry e; range (2 1); }")), "least first");
    EXPECT_SAYS(checked("method grid;" + tip + parameters("a { file f; entry e; range (0 1); scale log; }")),
                "above 0");
    EXPECT_SAYS(checked("method grid;" + tip + parameters("a { file f; entry e; range (0 1); scale lug; }")), "log");
    EXPECT_SAYS(checked("method latinHypercube;" + tip + parameters("a { file f; entry e; range (0 1); }")),
                "samples 12");
    EXPECT_SAYS(checked("method grid;" + tip + parameters("state { file f; entry e; values (1); }")), "another column");
    EXPECT_SAYS(checked("method grid;" + tip +
                        parameters("a { file f; entry e; values (1); } b { file f; entry e; values (1); }")),
                "change the same entry");
    EXPECT_SAYS(checked("method grid; results { t { function tip; value most; } }" + parameters(stiffness)),
                "timeOfMax");
    EXPECT_SAYS(checked("method grid; results { t { function tip; value at; } }" + parameters(stiffness)),
                "go together");
}

}  // namespace
}  // namespace pfem
