#include "study/caseCopy.hpp"

#include "sweepCase.hpp"

namespace pfem {
namespace {

namespace fs = std::filesystem;

class CaseCopies : public test::SweepFolder {
protected:
    CaseCopy copy(const std::vector<Change>& changes) const { return {root / "copy", changes, {"endTime"}}; }
    Dictionary copied(const char* file) const { return Dictionary::read(root / "copy" / file); }
};

// A value that macros take from another entry, or from a file that two dictionaries include, arrives everywhere.
TEST_F(CaseCopies, changesComeBeforeMacrosAndIncludes) {
    makeCopy(Case(root), copy({{"constant/materials", {"E0"}, "5"}, {"common", {"h"}, "0.25"}}));
    EXPECT_EQ(copied("constant/materials").subDict("rubber").get<double>("E"), 5);
    EXPECT_EQ(copied("constant/materials").subDict("steel").get<double>("E"), 5);
    EXPECT_EQ(copied("system/meshDict").get<double>("meshSize"), 0.25);
    EXPECT_DOUBLE_EQ(copied("system/controlDict").get<double>("deltaT"), 0.025);
    EXPECT_EQ(copied("system/controlDict").get<std::string>("startFrom"), "latestTime");
    EXPECT_TRUE(fs::exists(root / "copy/constant/wave.csv"));
    EXPECT_EQ(Dictionary::read(root / "common").get<double>("h"), 0.5);  // the case itself is as it was
    EXPECT_EQ(Dictionary::read(root / "system/controlDict").get<std::string>("startFrom"), "startTime");
}

TEST_F(CaseCopies, oneEntryOfSeveral) {
    put("system/sweepDict", "method grid;");
    makeCopy(Case(root),
             copy({{"constant/materials", {"rubber", "E"}, "7"}, {"system/pfemSolution", {"solid", "damping"}, "0"}}));
    EXPECT_EQ(copied("constant/materials").subDict("rubber").get<double>("E"), 7);
    EXPECT_EQ(copied("constant/materials").subDict("steel").get<double>("E"), 1e6);
    EXPECT_EQ(copied("system/pfemSolution").subDict("solid").get<double>("damping"), 0);
    EXPECT_FALSE(fs::exists(root / "copy/system/sweepDict"));
}

TEST_F(CaseCopies, resultsOfOtherDictionaries) {
    const Case theCase(root);
    makeCopy(theCase, copy({}));
    addTime(root / "copy", "0");
    makeCopy(theCase, copy({}));
    makeCopy(theCase, copy({{"system/controlDict", {"endTime"}, "3"}}));  // may go on for longer
    EXPECT_EQ(copied("system/controlDict").get<double>("endTime"), 3);
    for (const Change& change : {Change{"constant/materials", {"rubber", "E"}, "7"},
                                 {"common", {"h"}, "0.1"},
                                 {"system/controlDict", {"deltaT"}, "0.1"}})
        for (const auto how : {Copying::keep, Copying::compareOnly})
            EXPECT_NE(complaint([&] { makeCopy(theCase, copy({change}), how); }), "");
    const std::string text = complaint([&] {
        makeCopy(theCase, copy({{"constant/materials", {"rubber", "E"}, "7"}}));
    });
    EXPECT_NE(text.find("rubber.E: 1e6 -> 7"), std::string::npos) << text;
    EXPECT_NE(text.find("constant/materials"), std::string::npos) << text;
    put("constant/wave.csv", "0,2\n");
    EXPECT_NE(complaint([&] { makeCopy(theCase, copy({})); }).find("wave.csv"), std::string::npos);
    put("constant/wave.csv", "0,1\n");
    fs::remove(root / "constant/g");
    EXPECT_NE(complaint([&] { makeCopy(theCase, copy({})); }).find("constant/g"), std::string::npos);
    makeCopy(theCase, copy({}), Copying::overwrite);
    EXPECT_FALSE(fs::exists(root / "copy/0"));
    EXPECT_FALSE(fs::exists(root / "copy/constant/g"));
}

TEST_F(CaseCopies, compareOnlyWritesNothing) {
    makeCopy(Case(root), copy({}), Copying::compareOnly);
    EXPECT_FALSE(fs::exists(root / "copy"));
}

TEST_F(CaseCopies, sourcesAreDictionariesAndWhatTheyInclude) {
    const auto sources = sourcesOf(Case(root));
    EXPECT_EQ(sources, (std::vector<fs::path>{"common", "constant/g", "constant/materials", "system/controlDict",
                                              "system/meshDict", "system/pfemSolution"}));
}

}  // namespace
}  // namespace pfem
