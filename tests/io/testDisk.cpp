// A disk that is full, folders that cannot be written.
#include <signal.h>
#include <sys/resource.h>

#include <fstream>
#include <optional>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "io/series.hpp"
#include "io/stateFiles.hpp"
#include "io/table.hpp"
#include "sampleState.hpp"

namespace pfem {

using namespace test;
namespace fs = std::filesystem;

namespace {
/// No file may grow beyond `bytes` while this lives: what a full disk looks like to a program.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes) {
        previousHandler_ = signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &previous_);
        const rlimit limit{bytes, previous_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SmallDisk() {
        setrlimit(RLIMIT_FSIZE, &previous_);
        signal(SIGXFSZ, previousHandler_);
    }

private:
    rlimit previous_{};
    void (*previousHandler_)(int);
};
}  // namespace

TEST(FullDisk, StateIsWrittenWhollyOrNotAtAll) {
    const TemporaryFolder folder;
    writeState(folder.path() / "1", sampleState());
    State<2> later = sampleState();
    later.time.index = 8;
    for (const rlim_t size : {0u, 100u, 1000u, 2500u, 4000u}) {
        const SmallDisk disk(size);
        EXPECT_THROW(writeState(folder.path() / "1", later), UserError) << size;
        EXPECT_THROW(writeState(folder.path() / "2", later), UserError) << size;
    }
    expectIdentical(sampleState(), readState<2>(folder.path() / "1"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(FullDisk, AtomicFileKeepsTheOldContent) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "text";
    writeAtomically(file, "old");
    {
        const SmallDisk disk(10);
        EXPECT_THROW(writeAtomically(file, std::string(100000, 'x')), UserError);
    }
    EXPECT_EQ(readText(file), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(AtomicFile, LinksAndDevicesStay) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "text", link = folder.path() / "link", full = folder.path() / "full";
    writeAtomically(file, "old");
    fs::create_symlink(file, link);
    writeAtomically(link, "new");
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(readText(file), "new");
    fs::create_symlink("/dev/full", full);
    EXPECT_THROW(writeAtomically(full, "text"), UserError);
    EXPECT_TRUE(fs::is_symlink(full));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(FullDisk, TableReportsIt) {
    Table table("/dev/full", 6);
    EXPECT_THROW(table.row({"1", "2"}), UserError);
}

TEST(StagedFolder, KeepsAFileThatHasItsName) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "0.1") << "mine";
    writeState(folder.path() / "0.1", sampleState());
    EXPECT_TRUE(fs::is_directory(folder.path() / "0.1"));
    EXPECT_EQ(readText(folder.path() / "0.1.old"), "mine");
}

TEST(NotWritable, NamesTheFolder) {
    try {
        writeState("/proc/pfem/1", sampleState());
        FAIL();
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("/proc/pfem/1"), std::string::npos) << error.what();
    }
    EXPECT_THROW(writeAtomically("/proc/pfem/x", "text"), UserError);
    EXPECT_THROW(Table("/proc/pfem/x", 6), UserError);
}

TEST(Series, ListsTheCompleteFoldersThatExist) {
    const TemporaryFolder folder;
    State<2> state = sampleState();
    for (const auto& [name, value] :
         std::vector<std::pair<std::string, double>>{{"0", 0}, {"0.05", 0.05}, {"0.1", 0.1}}) {
        state.time.value = value;
        writeState(folder.path() / name, state);
    }
    fs::create_directories(folder.path() / "0.2");  // incomplete
    writeSeries(folder.path());
    const std::string pvd = readText(folder.path() / "case.pvd");
    EXPECT_NE(pvd.find("<DataSet timestep=\"0.05\" group=\"\" part=\"1\" name=\"solid\" file=\"0.05/solid.vtu\"/>"),
              std::string::npos)
        << pvd;
    EXPECT_EQ(pvd.find("0.2"), std::string::npos);
    EXPECT_LT(pvd.find("\"0.05/"), pvd.find("\"0.1/"));
    const std::string series = readText(folder.path() / "fluid.vtu.series");
    EXPECT_NE(series.find("\"file-series-version\" : \"1.0\""), std::string::npos);
    EXPECT_NE(series.find("{ \"name\" : \"0.05/fluid.vtu\", \"time\" : 0.05 }"), std::string::npos) << series;
    fs::remove_all(folder.path() / "0.05");
    writeSeries(folder.path());
    EXPECT_EQ(readText(folder.path() / "fluid.vtu.series").find("0.05"), std::string::npos);
}

TEST(Table, ColumnsOfOpenFoam) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "postProcessing/probes/0/p";
    Table table(file, 6);
    table.comment("Probe 0 (0.05 0.01 0)");
    table.header({"Probe", "0", "1", "2"});
    table.header({"Time"});
    table.row({table.number(0.0087317), table.number(938.395), table.number(-0.219067), table.number(-1e300)});
    table.row({table.number(0.1), table.tuple({1, 2.5, 0})});
    EXPECT_EQ(readText(file),
              "# Probe 0 (0.05 0.01 0)\n"
              "#       Probe             0             1             2\n"
              "#        Time\n"
              "    0.0087317       938.395     -0.219067       -1e+300\n"
              "          0.1             (1 2.5 0)\n");
}

TEST(Table, GoesOnUnderItsNameWhenTheFileIsRemovedOrReplaced) {
    const TemporaryFolder folder;
    const fs::path root = folder.path() / "case", file = root / "postProcessing/mass/0/volume";
    fs::create_directory(root);
    Table table(file, 6);
    table.header({"Time", "volume"});
    const std::string head = readText(file);
    table.line("0 1");
    fs::remove_all(root / "postProcessing");
    table.line("1 1");
    EXPECT_EQ(readText(file), head + "1 1\n");
    fs::copy_file(file, root / "edited");
    fs::rename(root / "edited", file);
    table.line("2 1");
    EXPECT_EQ(readText(file), head + "1 1\n2 1\n");
    fs::remove_all(root);
    EXPECT_THROW(table.line("3 1"), UserError);
    EXPECT_FALSE(fs::exists(root)) << "a case that has been deleted is made anew";
}

/// A table of `columns` columns with rows at these times, begun at `start`.
void writeRows(const fs::path& folder, const std::string& start, std::optional<double> resumeAt,
               const std::vector<double>& times, int columns = 1, int precision = 6) {
    Table table(folder / start / "p", precision, resumeAt);
    table.header(std::vector<std::string>(static_cast<std::size_t>(columns) + 1, "Time"));
    for (const double time : times) {
        std::vector<std::string> row{table.time(time)};
        for (int c = 0; c < columns; ++c) row.push_back(table.number(2 * time));
        table.row(row);
    }
}

TEST(Table, ARestartedRunGoesOnWithIt) {
    const TemporaryFolder folder;
    const double t = 0.123456789012345;  // the folder's name is rounded
    writeRows(folder.path(), "0", {}, {0, 0.1, t, t + 1e-9, 0.2, 0.3});
    const std::string whole = readText(folder.path() / "0/p");
    std::ofstream(folder.path() / "0/p", std::ios::app) << "   0.1";  // killed in the middle of a line
    writeRows(folder.path(), "0.123457", t, {t + 1e-9, 0.2, 0.3});
    EXPECT_EQ(readText(folder.path() / "0/p"), whole);
    EXPECT_FALSE(fs::exists(folder.path() / "0.123457"));
    writeRows(folder.path(), "0.3", 0.3, {});  // no row: nothing happens
    EXPECT_EQ(readText(folder.path() / "0/p"), whole);

    writeRows(folder.path(), "0.2", 0.2, {0.25}, 2);  // other columns: a table of its own
    EXPECT_EQ(readText(folder.path() / "0/p"), whole);
    EXPECT_TRUE(fs::exists(folder.path() / "0.2/p"));
    writeRows(folder.path(), "0.25", 0.25, {0.3}, 2);
    EXPECT_NE(readText(folder.path() / "0.2/p").find("0.6"), std::string::npos);
}

TEST(Table, ARowIsFoundAgainWithAnyPrecision) {
    for (int precision = 1; precision <= 17; ++precision)
        for (const double t : {2.0 / 3, 0.1 + 0.2, 1.0 / 7, 123.456789012345678}) {
            const TemporaryFolder folder;
            writeRows(folder.path(), "0", {}, {0, t, 2 * t}, 1, precision);
            const std::string whole = readText(folder.path() / "0/p");
            writeRows(folder.path(), "0.1", t, {2 * t}, 1, precision);
            EXPECT_EQ(readText(folder.path() / "0/p"), whole) << precision << " digits";
        }
}

}  // namespace pfem
