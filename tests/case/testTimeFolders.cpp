#include <fstream>

#include "../io/sampleState.hpp"
#include "base/error.hpp"
#include "case/case.hpp"
#include "case/timeFolders.hpp"
#include "io/stateFiles.hpp"

namespace pfem {

using namespace test;
namespace fs = std::filesystem;

TEST(TimeName, AsOStreamPrints) {
    EXPECT_EQ(timeName(0), "0");
    EXPECT_EQ(timeName(-0.0), "0");
    EXPECT_EQ(timeName(0.05), "0.05");
    EXPECT_EQ(timeName(0.1), "0.1");
    EXPECT_EQ(timeName(0.1 + 0.2), "0.3");
    EXPECT_EQ(timeName(10), "10");
    EXPECT_EQ(timeName(1e-6), "1e-06");
    EXPECT_EQ(timeName(1234567), "1.23457e+06");
    EXPECT_EQ(timeName(1234567, "general", 7), "1234567");
    EXPECT_EQ(timeName(0.05, "fixed", 3), "0.050");
    EXPECT_EQ(timeName(0.05, "scientific", 2), "5.00e-02");
}

TEST(TimeName, PrecisionGrowsUntilNamesDiffer) {
    EXPECT_EQ(precisionToDistinguish(0.1, 0.2, "general", 6), 6);
    EXPECT_EQ(precisionToDistinguish(1.0, 1.00000001, "general", 6), 9);
    EXPECT_EQ(precisionToDistinguish(1.0, 1.0, "general", 6), 6);
    EXPECT_EQ(precisionToDistinguish(1.0, std::nextafter(1.0, 2), "general", 6), 17);
}

TEST(TimeFolders, OfOneTimeByNames) {
    const TemporaryFolder folder;
    State<2> empty;
    for (const char* name : {"0.50", "0.5", "0.4"}) writeState(folder.path() / name, empty);
    std::vector<std::string> names;
    for (const auto& time : listTimes(folder.path()).complete) names.push_back(time.name);
    EXPECT_EQ(names, (std::vector<std::string>{"0.4", "0.5", "0.50"}));  // whatever the order of the disk
}

TEST(TimeFolders, NumbersOnlySortedByValue) {
    const TemporaryFolder folder;
    State<2> empty;
    for (const char* name : {"10", "9", "0", "0.05", "1e-06", "-1"}) writeState(folder.path() / name, empty);
    for (const char* name :
         {"constant", "0.orig", "system", "nan", "inf", "0x10", "1.2.3", ".5.tmp", "5abc", ".0.1.tmp"})
        fs::create_directories(folder.path() / name);
    std::ofstream(folder.path() / "7") << "a file";
    fs::create_directories(folder.path() / "3");
    fs::remove(folder.path() / "9/solid.vtu");
    const TimeFolders times = listTimes(folder.path());
    std::vector<std::string> names;
    for (const auto& time : times.complete) names.push_back(time.name);
    EXPECT_EQ(names, (std::vector<std::string>{"-1", "0", "1e-06", "0.05", "10"}));
    ASSERT_EQ(times.ignored.size(), 2u);
    EXPECT_EQ(times.ignored[0].name, "3");
    EXPECT_EQ(times.ignored[1].reason, "solid.vtu is missing");
}

TEST(Case, MissingFolder) {
    try {
        const Case none("/nonexist", "pfemX");
        FAIL();
    } catch (const UserError& error) {
        EXPECT_STREQ(error.what(), "pfemX: cannot open case directory \"/nonexist\"");
    }
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "file") << "x";
    EXPECT_THROW(Case(folder.path() / "file"), UserError);
    EXPECT_EQ(Case(folder.path()).name(), folder.path().filename().string());
}

}  // namespace pfem
