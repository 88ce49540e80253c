// The lists for ParaView while a run adds time folders.
#include <signal.h>
#include <sys/resource.h>

#include <fmt/format.h>

#include <fstream>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "io/series.hpp"
#include "sampleState.hpp"

namespace pfem {

using namespace test;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> lists{"case.pvd", "fluid.vtu.series", "solid.vtu.series", "boundary.vtu.series"};

/// A time folder that looks complete.
void makeTime(const fs::path& root, const std::string& name) {
    fs::create_directories(root / name / "uniform");
    for (const char* file : {"uniform/time", "fluid.vtu", "solid.vtu", "boundary.vtu"})
        std::ofstream(root / name / file) << "x";
}

std::string nameOf(int k) { return fmt::format("{:.3f}", 1 + 1e-3 * k); }

void addTime(Series& series, const fs::path& root, const std::string& name) {
    series.look();
    makeTime(root, name);
    series.add(name);
}

std::vector<std::string> textsOf(const fs::path& root) {
    std::vector<std::string> texts;
    for (const auto& list : lists) texts.push_back(readText(root / list));
    return texts;
}

/// The lists are those that are made anew from what the root holds.
void expectTrue(const fs::path& root, const char* when) {
    const auto grown = textsOf(root);
    writeSeries(root);
    EXPECT_EQ(grown, textsOf(root)) << when;
}

/// Bytes that this process has handed to the system for writing, so far.
long bytesWritten() {
    std::ifstream file("/proc/self/io");
    for (std::string word; file >> word;)
        if (word == "wchar:" && file >> word) return std::stol(word);
    return -1;
}

bool holds(const fs::path& root, const std::string& time) {
    return readText(root / "case.pvd").find("\"" + time + "/") != std::string::npos;
}

}  // namespace

TEST(Series, GrowsToWhatIsWrittenWhole) {
    const TemporaryFolder folder, other;
    Series series(folder.path());
    for (int k = 0; k < 120; ++k) {  // past the time at which the root is looked through again
        addTime(series, folder.path(), nameOf(k));
        makeTime(other.path(), nameOf(k));
        if (k > 3 && k % 50 > 2) continue;
        writeSeries(other.path());
        ASSERT_EQ(textsOf(folder.path()), textsOf(other.path())) << k;
    }
}

TEST(Series, AFolderCostsTheSameHoweverManyThereAre) {
    if (bytesWritten() < 0) GTEST_SKIP() << "the system does not count";
    std::vector<long> costs;
    for (const int n : {20, 400}) {
        const TemporaryFolder folder;
        for (int k = 0; k < n; ++k) makeTime(folder.path(), nameOf(k));
        Series series(folder.path());
        series.write();
        addTime(series, folder.path(), nameOf(n));  // makes the twins
        addTime(series, folder.path(), nameOf(n + 1));
        series.look();
        makeTime(folder.path(), nameOf(n + 2));
        const long before = bytesWritten();
        series.add(nameOf(n + 2));
        costs.push_back(bytesWritten() - before);
    }
    EXPECT_EQ(costs[0], costs[1]);
    EXPECT_LT(costs[1], 2000);

    const TemporaryFolder folder;
    for (int k = 0; k < 50; ++k) makeTime(folder.path(), nameOf(k));
    Series series(folder.path());
    series.write();
    for (int k = 7; k < 9; ++k) {  // a run that is done again
        series.look();
        makeTime(folder.path(), nameOf(k));
        const long before = bytesWritten();
        series.add(nameOf(k));
        EXPECT_EQ(bytesWritten(), before);
    }
    expectTrue(folder.path(), "done again");
}

TEST(Series, TheRootIsLookedThroughOnlyWhenItHasChanged) {
    const TemporaryFolder folder;
    const fs::path& root = folder.path();
    Series series(root);
    addTime(series, root, "1");
    const auto changed = fs::last_write_time(root);
    makeTime(root, "1.5");
    fs::last_write_time(root, changed);  // as if nothing had happened
    addTime(series, root, "2");
    EXPECT_FALSE(holds(root, "1.5"));
    fs::last_write_time(root, changed + std::chrono::seconds(1));
    addTime(series, root, "3");
    EXPECT_TRUE(holds(root, "1.5"));
    fs::remove_all(root / "1.5");
    fs::last_write_time(root, changed + std::chrono::seconds(2));
    addTime(series, root, "4");
    EXPECT_FALSE(holds(root, "1.5"));
    expectTrue(root, "removed");
}

TEST(Series, WhatOthersDoToTheListsIsMended) {
    const TemporaryFolder folder;
    const fs::path& root = folder.path();
    Series series(root);
    for (const char* name : {"1", "2", "3"}) addTime(series, root, name);
    const auto inPlace = [&](const std::string& name) {  // the root's own time stays
        const auto changed = fs::last_write_time(root);
        std::ofstream(root / name) << "edited";
        fs::last_write_time(root, changed);
    };
    inPlace("case.pvd");
    addTime(series, root, "4");
    expectTrue(root, "edited");
    addTime(series, root, "5");  // writeSeries() has replaced the files
    expectTrue(root, "replaced");
    addTime(series, root, "6");
    addTime(series, root, "7");
    inPlace(".case.pvd.twin");
    addTime(series, root, "8");
    expectTrue(root, "twin edited");
    addTime(series, root, "7.5");  // not the last
    expectTrue(root, "in between");
    addTime(series, root, "7.5");
    expectTrue(root, "again");
    fs::remove(root / "fluid.vtu.series");
    addTime(series, root, "9");
    expectTrue(root, "removed");

    const TemporaryFolder other;
    fs::rename(root / "case.pvd", other.path() / "kept.pvd");
    fs::create_symlink(other.path() / "kept.pvd", root / "case.pvd");
    for (const char* name : {"10", "11"}) addTime(series, root, name);
    EXPECT_TRUE(fs::is_symlink(root / "case.pvd"));
    EXPECT_TRUE(holds(root, "11"));
}

TEST(Series, AFullDiskLeavesWholeLists) {
    const TemporaryFolder folder;
    const fs::path& root = folder.path();
    {
        Series series(root);
        for (int k = 0; k < 20; ++k) addTime(series, root, nameOf(k));
        const auto whole = textsOf(root);
        series.look();
        makeTime(root, nameOf(20));
        const auto handler = signal(SIGXFSZ, SIG_IGN);
        rlimit previous{};
        getrlimit(RLIMIT_FSIZE, &previous);
        const rlimit full{whole[0].size() + 20, previous.rlim_max};
        setrlimit(RLIMIT_FSIZE, &full);
        EXPECT_THROW(series.add(nameOf(20)), UserError);
        setrlimit(RLIMIT_FSIZE, &previous);
        signal(SIGXFSZ, handler);
        EXPECT_EQ(textsOf(root), whole);
        addTime(series, root, nameOf(21));  // when there is room again
        expectTrue(root, "after a full disk");
        addTime(series, root, nameOf(22));
    }
    for (const auto& entry : fs::directory_iterator(root))
        EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path() << " is left";
}

TEST(Series, WhatAKilledRunLeavesGoes) {
    const TemporaryFolder folder;
    const fs::path& root = folder.path();
    std::ofstream(root / ".case.pvd.twin") << "half an entr";
    Series series(root);
    addTime(series, root, "1");
    EXPECT_FALSE(fs::exists(root / ".case.pvd.twin"));
    addTime(series, root, "2");
    addTime(series, root, "3");
    expectTrue(root, "after a kill");
}

}  // namespace pfem
