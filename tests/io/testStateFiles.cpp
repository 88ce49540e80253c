#include <fstream>
#include <limits>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "io/stateFiles.hpp"
#include "sampleState.hpp"

namespace pfem {

using namespace test;
namespace fs = std::filesystem;

namespace {
const char* const allFiles[] = {"fluid.vtu", "solid.vtu", "boundary.vtu", "uniform/time"};

void put(const fs::path& file, const std::string& bytes) {
    std::ofstream stream(file, std::ios::binary);
    stream << bytes;
}

/// Without the checksums, so that the checks behind them are tested too.
void removeChecksums(const fs::path& folder) {
    const std::string text = readText(folder / "uniform/time");
    put(folder / "uniform/time",
        text.substr(0, text.find("checksums")) + "checksums { fluid.vtu none; solid.vtu none; boundary.vtu none; }\n");
}
}  // namespace

TEST(StateFiles, RoundTripRestoresEveryBit) {
    const TemporaryFolder folder;
    const State<2> state = sampleState();
    writeState(folder.path() / "0.3", state);
    expectIdentical(state, readState<2>(folder.path() / "0.3"));
}

// Sizes that belong to places: a box, a curve, a point, a patch.
TEST(StateFiles, SizesOfPlaces) {
    const TemporaryFolder folder;
    State<2> state = sampleState();
    const Vec<2> a(1.0 / 3, -1e-17), b(0.1, 1e300);
    state.sizes.coarsest = 1.0 / 7;
    auto& places = state.sizes.places;
    places.resize(3);
    for (std::size_t k = 0; k < 3; ++k) places[k].meshSize = 0.01 / static_cast<double>(k + 1);
    places[0].box = {a, b};
    places[1].faces = {{a, b}, {b, b}};
    places[1].distance = 1.0 / 9;
    places[2].patch = "walls";
    writeState(folder.path() / "0.3", state);
    const auto read = readState<2>(folder.path() / "0.3").sizes;
    EXPECT_TRUE(read.hold());
    EXPECT_EQ(read.coarsest, state.sizes.coarsest);
    ASSERT_EQ(read.places.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto &was = state.sizes.places[k], &is = read.places[k];
        EXPECT_EQ(is.meshSize, was.meshSize);
        EXPECT_EQ(is.distance, was.distance);
        EXPECT_EQ(is.box, was.box);
        EXPECT_EQ(is.faces, was.faces);
        EXPECT_EQ(is.patch, was.patch);
    }
    const auto file = folder.path() / "0.3/uniform/sizes";
    put(file, readText(file) + " ");
    EXPECT_THROW(readState<2>(folder.path() / "0.3"), UserError);
    fs::remove(file);
    EXPECT_THROW(readState<2>(folder.path() / "0.3"), UserError);
    writeState(folder.path() / "0.4", sampleState());
    EXPECT_FALSE(fs::exists(folder.path() / "0.4/uniform/sizes"));
}

// Folders from before energy was counted.
TEST(StateFiles, WithoutEnergy) {
    const TemporaryFolder folder;
    writeState(folder.path() / "0.3", sampleState());
    std::string text = readText(folder.path() / "0.3/uniform/time");
    const auto begin = text.find("energy");
    text.erase(begin, text.find('}', begin) + 1 - begin);
    put(folder.path() / "0.3/uniform/time", text);
    EXPECT_TRUE(readState<2>(folder.path() / "0.3").energy.byName().empty());
}

// Nodal integration: no stress in cells.
TEST(StateFiles, WithoutStressInCells) {
    const TemporaryFolder folder;
    State<2> state = sampleState();
    state.mesh.solid.sigma.clear();
    writeState(folder.path() / "0.3", state);
    expectIdentical(state, readState<2>(folder.path() / "0.3"));
    state.mesh.solid.sigma.resize(1, Stress<2>::Zero());
    EXPECT_THROW(writeState(folder.path() / "0.3", state), InternalError);
}

TEST(StateFiles, EmptyStateIsValid) {
    const TemporaryFolder folder;
    State<2> state;
    writeState(folder.path() / "0", state);
    expectIdentical(state, readState<2>(folder.path() / "0"));
    state.mesh.materials = {"water"};
    state.mesh.patches = {{"walls", {}}};
    writeState(folder.path() / "0", state);
    expectIdentical(state, readState<2>(folder.path() / "0"));
}

TEST(StateFiles, OnlyFluidOnlySolidOnlyParticles) {
    const TemporaryFolder folder;
    for (int kind = 0; kind < 3; ++kind) {
        State<2> state = sampleState();
        if (kind != 0) state.mesh.fluid = {};
        if (kind != 1) state.mesh.solid = {};
        if (kind == 2) state.mesh.patches.clear();
        writeState(folder.path() / "1", state);  // stresses remain at nodes of no solid: kept as well
        expectIdentical(state, readState<2>(folder.path() / "1"));
    }
}

TEST(StateFiles, SameStateSameBytes) {
    const TemporaryFolder folder;
    for (const char* name : {"a", "b"})
        fs::create_directory(folder.path() / name);  // a case is never made by writing into it
    writeState(folder.path() / "a" / "1", sampleState());
    writeState(folder.path() / "b" / "1", sampleState());
    for (const char* file : allFiles)
        EXPECT_EQ(readText(folder.path() / "a/1" / file), readText(folder.path() / "b/1" / file)) << file;
}

TEST(StateFiles, ReplacesAFolderAndLeavesNothingElse) {
    const TemporaryFolder folder;
    State<2> state = sampleState();
    writeState(folder.path() / "1", state);
    state.time.index = 99;
    writeState(folder.path() / "1", state);
    EXPECT_EQ(readState<2>(folder.path() / "1").time.index, 99);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(StateFiles, ExtraFieldsAreWrittenAndNotNeeded) {
    const TemporaryFolder folder;
    const State<2> state = sampleState();
    const auto n = static_cast<std::size_t>(state.nodes.size());
    ExtraFields extra;
    extra.nodal["solidPressure"].assign(n, 2.5);
    extra.nodalFlags["freeSurface"].assign(n, 1);
    writeState(folder.path() / "1", state, extra);
    const std::string text = readText(folder.path() / "1/fluid.vtu");
    EXPECT_NE(text.find("type=\"UInt8\" Name=\"freeSurface\""), std::string::npos);
    EXPECT_NE(text.find("Name=\"solidPressure\""), std::string::npos);
    expectIdentical(state, readState<2>(folder.path() / "1"));
    extra.nodal["solidPressure"].pop_back();
    EXPECT_THROW(writeState(folder.path() / "1", state, extra), InternalError);
}

TEST(StateFiles, ArraysAsParaViewWantsThem) {
    const TemporaryFolder folder;
    writeState(folder.path() / "1", sampleState());
    const std::string solid = readText(folder.path() / "1/solid.vtu");
    for (const char* part :
         {"type=\"Float64\" Name=\"U\" NumberOfComponents=\"3\"", "Vectors=\"U\"", "GlobalIds=\"id\"",
          "Name=\"sigma\" NumberOfComponents=\"6\"", "ComponentName0=\"XX\"", "ComponentName3=\"XY\"",
          "ComponentName4=\"YZ\"", "Name=\"TimeValue\"", "type=\"Int32\" Name=\"material\"",
          "type=\"Float64\" Name=\"Points\"", "encoding=\"raw\"", "vtkZLibDataCompressor", "Name=\"D\""})
        EXPECT_NE(solid.find(part), std::string::npos) << part;
}

TEST(StateFiles, BrokenPromisesAreInternalErrors) {
    const TemporaryFolder folder;
    State<2> state = sampleState();
    state.nodes.p.pop_back();
    EXPECT_THROW(writeState(folder.path() / "1", state), InternalError);
    state = sampleState();
    state.mesh.fluid.nodes[0][1] = 99;
    EXPECT_THROW(writeState(folder.path() / "1", state), InternalError);
    state = sampleState();
    std::swap(state.nodes.id[0], state.nodes.id[1]);
    EXPECT_THROW(writeState(folder.path() / "1", state), InternalError);
    state = sampleState();
    state.nextId = 5;
    EXPECT_THROW(writeState(folder.path() / "1", state), InternalError);
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(StateFiles, MissingFileIsNamed) {
    const TemporaryFolder folder;
    for (const char* file : allFiles) {
        writeState(folder.path() / "1", sampleState());
        fs::remove(folder.path() / "1" / file);
        try {
            readState<2>(folder.path() / "1");
            FAIL() << file;
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
        }
    }
}

class Damaged : public testing::TestWithParam<bool> {};

/// Cut at many places: an error that names the file, never a crash and never a state.
/// (The last 30 bytes close XML elements after all data: a reader need not look at them.)
TEST_P(Damaged, TruncatedFiles) {
    const TemporaryFolder folder;
    for (const char* name : {"fluid.vtu", "solid.vtu", "boundary.vtu"}) {
        writeState(folder.path() / "1", sampleState());
        if (GetParam()) removeChecksums(folder.path() / "1");
        const fs::path file = folder.path() / "1" / name;
        const std::string whole = readText(file);
        for (std::size_t size = 0; size + 40 < whole.size(); size += 1 + whole.size() / 60) {
            put(file, whole.substr(0, size));
            try {
                readState<2>(folder.path() / "1");
                ADD_FAILURE() << name << " cut at " << size << " of " << whole.size() << " was read";
            } catch (const UserError& error) {
                EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
            }
        }
    }
}

/// Every changed byte is found (without checksums VTK itself would crash on some).
TEST(StateFiles, FlippedBytes) {
    const TemporaryFolder folder;
    for (const char* name : {"fluid.vtu", "solid.vtu", "boundary.vtu"}) {
        writeState(folder.path() / "1", sampleState());
        const fs::path file = folder.path() / "1" / name;
        const std::string whole = readText(file);
        for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 400) {
            std::string bytes = whole;
            bytes[i] = static_cast<char>(bytes[i] ^ 0x15);
            put(file, bytes);
            EXPECT_THROW(readState<2>(folder.path() / "1"), UserError) << name << ", byte " << i;
        }
    }
}

/// VTK's reader itself writes behind its memory when an array of strings holds more than it says.
TEST(StateFiles, StringsAreCountedBeforeTheyAreRead) {
    const TemporaryFolder folder;
    writeState(folder.path() / "1", sampleState());
    const fs::path file = folder.path() / "1" / "fluid.vtu";
    std::string text = readText(file);
    removeChecksums(folder.path() / "1");
    const std::string said = "Name=\"materials\" NumberOfTuples=\"";
    const auto at = text.find(said);
    ASSERT_NE(at, std::string::npos);
    for (const char number : {'0', '1', '9'}) {
        text[at + said.size()] = number;
        put(file, text);
        try {
            readState<2>(folder.path() / "1");
            ADD_FAILURE() << "no error for " << number;
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find("array 'materials'"), std::string::npos) << error.what();
        }
    }
}

/// VTK trusts the head: an array that is shorter than it promises is read behind its end.
TEST(StateFiles, ArraysHaveTheSizeThatIsPromised) {
    const TemporaryFolder folder;
    writeState(folder.path() / "1", sampleState());
    removeChecksums(folder.path() / "1");
    const fs::path file = folder.path() / "1" / "fluid.vtu";
    const std::string whole = readText(file), said = "Name=\"U\" NumberOfComponents=\"";
    std::string text = whole;
    const auto at = text.find(said);
    ASSERT_NE(at, std::string::npos);
    text[at + said.size()] = '9';
    put(file, text);
    try {
        readState<2>(folder.path() / "1");
        ADD_FAILURE() << "no error";
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("array 'U' has"), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Checksums, Damaged, testing::Values(false, true),
                         [](const auto& parameter) { return parameter.param ? "without" : "with"; });

TEST(StateFiles, WrongContentIsAnError) {
    const TemporaryFolder folder;
    const fs::path time = folder.path() / "1";
    auto expectError = [&](const char* what) {
        try {
            readState<2>(time);
            ADD_FAILURE() << what;
        } catch (const UserError&) {
        }
    };
    State<2> state = sampleState();
    state.nodes.p[1] = std::numeric_limits<double>::quiet_NaN();
    writeState(time, state);
    expectError("NaN pressure");
    state = sampleState();
    state.nodes.x[0][1] = std::numeric_limits<double>::infinity();
    writeState(time, state);
    expectError("infinite position");
    state = sampleState();
    state.mesh.fluid.material[1] = 3;
    writeState(time, state);
    expectError("material that does not exist");
    state = sampleState();
    state.mesh.solid.nodes[0] = {5, 5, 4};
    writeState(time, state);
    expectError("triangle with a node twice");

    // files of different times mixed
    State<2> other = sampleState();
    other.nodes.p[1] = 5;
    writeState(folder.path() / "2", other);
    writeState(time, sampleState());
    fs::copy_file(folder.path() / "2/solid.vtu", time / "solid.vtu", fs::copy_options::overwrite_existing);
    expectError("file of another state, checksum");
    removeChecksums(time);
    expectError("file of another state, contents");
    fs::copy_file(folder.path() / "2/boundary.vtu", time / "solid.vtu", fs::copy_options::overwrite_existing);
    expectError("boundary in place of solid");
}

TEST(StateFiles, UniformTimeThatMakesNoSense) {
    const TemporaryFolder folder;
    writeState(folder.path() / "1", sampleState());
    const fs::path file = folder.path() / "1/uniform/time";
    const std::string whole = readText(file);
    for (const auto& [from, to] :
         std::vector<std::pair<std::string, std::string>>{{"index           7", "index           -7"},
                                                          {"index           7", "index           1.5"},
                                                          {"nextId          4000000000", "nextId          12"},
                                                          {"deltaT0", "delta0"},
                                                          {"0.30000000000000004", "nan"},
                                                          {"ledger", "leader"}}) {
        std::string text = whole;
        ASSERT_NE(text.find(from), std::string::npos) << from;
        text.replace(text.find(from), from.size(), to);
        put(file, text);
        EXPECT_THROW(readState<2>(folder.path() / "1"), UserError) << to;
    }
    for (std::size_t size = 0; size < whole.find("checksums") - 3; size += 13) {
        put(file, whole.substr(0, size));
        EXPECT_THROW(readState<2>(folder.path() / "1"), UserError) << size;
    }
}

}  // namespace pfem
