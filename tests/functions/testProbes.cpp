#include <Eigen/Geometry>
#include <fstream>
#include <iterator>
#include <sstream>

#include "../io/sampleState.hpp"
#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "case/timeFolders.hpp"
#include "functions/functionObjects.hpp"
#include "functions/massBalance.hpp"
#include "io/stateFiles.hpp"
#include "mesh/locate.hpp"

namespace pfem {

using namespace test;
namespace fs = std::filesystem;

namespace {

/// Fluid block [0,1]x[0,1] and solid block [1,2]x[0,1] of n x n squares each, two triangles a square;
/// the interface x = 1 shared. Fields are linear in X.
State<2> blocks(int n) {
    State<2> s;
    const int columns = 2 * n + 1;
    auto index = [&](int i, int j) { return j * columns + i; };
    s.nodes.resize(columns * (n + 1));
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i < columns; ++i) {
            const auto k = static_cast<std::size_t>(index(i, j));
            s.nodes.id[k] = static_cast<Id>(3 * k + 1);
            s.nodes.X[k] = Vec<2>(i, j) / n;
            s.nodes.x[k] = s.nodes.X[k];
            const double x = s.nodes.X[k][0], y = s.nodes.X[k][1];
            s.nodes.v[k] = {1 + 2 * x - y, 3 * x + 4 * y};
            s.nodes.p[k] = 10 - 5 * x + y;
            if (i >= n) s.nodes.sigma[k] << x, y, x + y, x - y;
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < 2 * n; ++i) {
            Cells<2>& cells = i < n ? s.mesh.fluid : s.mesh.solid;
            cells.nodes.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
            cells.nodes.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
            cells.material.insert(cells.material.end(), 2, i < n ? 0 : 1);
        }
    s.mesh.materials = {"water", "rubber"};
    s.nextId = s.nodes.id.back() + 1;
    return s;
}

/// Turn the solid block (and its interface) about (1, 0).
void rotateSolid(State<2>& state, double angle) {
    const Eigen::Rotation2D<double> rotation(angle);
    const Vec<2> centre(1, 0);
    for (std::size_t i = 0; i < state.nodes.x.size(); ++i)
        if (state.nodes.X[i][0] >= 1) state.nodes.x[i] = centre + rotation * (state.nodes.X[i] - centre);
}

class Functions : public testing::Test {
protected:
    Functions() {
        fs::create_directories(folder_.path() / "constant");
        std::ofstream(folder_.path() / "constant/materials")
            << "water { type newtonian; rho [1 -3 0 0 0 0 0] 1000; } rubber { type hypoelastic; rho 1200; }";
    }
    FunctionObjects<2> make(const std::string& text, const std::string& startName = "0") const {
        return {Case(folder_.path()), Dictionary::parse("functions { " + text + " }", "controlDict"), startName};
    }
    /// Rows of a table, comments left out; brackets are blanks.
    std::vector<std::vector<double>> rows(const std::string& file) const {
        std::istringstream lines(readText(folder_.path() / "postProcessing" / file));
        std::vector<std::vector<double>> table;
        for (std::string line; std::getline(lines, line);) {
            if (line[0] == '#') continue;
            for (char& c : line)
                if (c == '(' || c == ')') c = ' ';
            std::istringstream words(line);
            table.emplace_back(std::istream_iterator<double>(words), std::istream_iterator<double>());
        }
        return table;
    }
    TemporaryFolder folder_;
};

}  // namespace

TEST(Locate, EveryPointOfTheMeshAndNoOther) {
    const State<2> state = blocks(5);
    for (double x = 0; x <= 1.0; x += 1.0 / 37)
        for (double y = 0; y <= 1.0; y += 1.0 / 41) {
            const auto at = locate<2>(state.mesh.fluid, state.nodes.x, {x, y});
            ASSERT_TRUE(at);
            EXPECT_NEAR((interpolate<2>(*at, state.nodes.x) - Vec<2>(x, y)).norm(), 0, 1e-15);
            EXPECT_NEAR(at->weights.sum(), 1, 1e-15);
        }
    EXPECT_TRUE(locate<2>(state.mesh.fluid, state.nodes.x, {1, 1}));
    EXPECT_FALSE(locate<2>(state.mesh.fluid, state.nodes.x, {1.001, 0.5}));
    EXPECT_FALSE(locate<2>(state.mesh.fluid, state.nodes.x, {-1e-3, -1e-3}));
    EXPECT_FALSE(locate<2>(Cells<2>{}, state.nodes.x, {0.5, 0.5}));
}

TEST(Locate, DegenerateCellsAreSkipped) {
    const Points<2> x{{0, 0}, {1, 0}, {2, 0}, {0, 1}};
    const Cells<2> cells{{{0, 1, 2}, {0, 1, 3}}, {0, 0}};
    const auto at = locate<2>(cells, x, {0.25, 0});
    ASSERT_TRUE(at);
    EXPECT_EQ(at->cell, 1);
}

TEST_F(Functions, FixedProbesReproduceLinearFields) {
    auto functions = make(
        "inside { type probes; libs (sampling); fields (p U D sigma); writePrecision 15;"
        " probeLocations ((0.31 0.47 0) (1.62 0.13 0) (1 0.5 0) (9 9 9)); }");
    State<2> state = blocks(4);
    state.time.value = 0.25;
    functions.start(state);  // index 0: a row
    const auto p = rows("inside/0/p");
    ASSERT_EQ(p.size(), 1u);
    EXPECT_EQ(p[0][0], 0.25);
    EXPECT_NEAR(p[0][1], 10 - 5 * 0.31 + 0.47, 1e-13);
    EXPECT_EQ(p[0][2], -1e300) << "no fluid there";
    EXPECT_NEAR(p[0][3], 10 - 5 + 0.5, 1e-13);
    EXPECT_EQ(p[0][4], -1e300);
    const auto U = rows("inside/0/U");
    EXPECT_NEAR(U[0][1], 1 + 2 * 0.31 - 0.47, 1e-13);
    EXPECT_NEAR(U[0][2], 3 * 0.31 + 4 * 0.47, 1e-13);
    EXPECT_EQ(U[0][3], 0);
    EXPECT_NEAR(U[0][4], 1 + 2 * 1.62 - 0.13, 1e-13);
    const auto sigma = rows("inside/0/sigma");  // xx xy xz yy yz zz
    EXPECT_EQ(sigma[0][1], -1e300);
    EXPECT_NEAR(sigma[0][7], 1.62, 1e-13);
    EXPECT_NEAR(sigma[0][8], 1.62 - 0.13, 1e-13);
    EXPECT_EQ(sigma[0][9], 0);
    EXPECT_NEAR(sigma[0][10], 0.13, 1e-13);
    EXPECT_NEAR(sigma[0][12], 1.62 + 0.13, 1e-13);
}

TEST_F(Functions, ProbeFileLooksLikeOpenFoams) {
    auto functions = make("probes { type probes; fields (p); points ((0.5 0.25 0) (9 9 9)); }");
    functions.start(blocks(2));
    EXPECT_EQ(readText(folder_.path() / "postProcessing/probes/0/p"),
              "# Probe 0 (0.5 0.25 0)\n"
              "# Probe 1 (9 9 9)  # Not Found\n"
              "#       Probe             0             1\n"
              "#        Time\n"
              "            0          7.75       -1e+300\n");
}

TEST_F(Functions, AttachedProbeFollowsARotation) {
    const std::string text =
        "tip { type probes; fields (D U); fixedLocations false; writePrecision 15; probeLocations ((1.9 0.7 "
        "0) (2 1 0)); }";
    State<2> state = blocks(3);
    writeState(folder_.path() / "0", state);
    auto functions = make(text);
    functions.start(state);
    auto later = [&](int k) {
        State<2> turned = state;
        rotateSolid(turned, 0.3 * k);
        turned.time = {0.1 * k, k, 0.1, 0.1};
        return turned;
    };
    for (int k = 1; k <= 6; ++k) functions.execute(later(k));
    const auto D = rows("tip/0/D");
    ASSERT_EQ(D.size(), 7u);
    for (int k = 0; k <= 6; ++k) {
        const Vec<2> arm(0.9, 0.7);
        const Vec<2> expected = Eigen::Rotation2D<double>(0.3 * k) * arm - arm;
        EXPECT_NEAR(D[static_cast<std::size_t>(k)][1], expected[0], 1e-13);
        EXPECT_NEAR(D[static_cast<std::size_t>(k)][2], expected[1], 1e-13);
    }
    // restarted after the third step: the same material point, rows go on in a folder of their own
    auto restarted = make(text, "0.3");
    restarted.start(later(3));
    for (int k = 4; k <= 6; ++k) restarted.execute(later(k));
    const auto again = rows("tip/0.3/D");
    ASSERT_EQ(again.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(again[i], D[i + 4]);
}

// Round bodies have sides of chords: a point of the true side rides on the cell beside it, one far away on nothing.
TEST_F(Functions, AttachedProbeMayBeALittleBesideItsMaterial) {
    State<2> state = blocks(2);
    writeState(folder_.path() / "0", state);
    auto functions = make(
        "tip { type probes; fields (D); fixedLocations false; writePrecision 15; "
        "probeLocations ((2.02 0.6 0) (2.01 1.02 0) (2.2 0.6 0)); }");
    testing::internal::CaptureStderr();
    functions.start(state);
    const std::string warnings = testing::internal::GetCapturedStderr();
    EXPECT_NE(warnings.find("probe 2 of function 'tip', (2.2 0.6 0)"), std::string::npos) << warnings;
    EXPECT_EQ(warnings.find("probe 1 "), std::string::npos) << warnings;
    State<2> turned = state;
    rotateSolid(turned, 0.3);
    turned.time = {0.1, 1, 0.1, 0.1};
    functions.execute(turned);
    const auto D = rows("tip/0/D").at(1);
    for (const auto& [column, arm] : {std::pair<std::size_t, Vec<2>>{1, {1.02, 0.6}}, {4, {1.01, 1.02}}}) {
        const Vec<2> expected = Eigen::Rotation2D<double>(0.3) * arm - arm;
        EXPECT_NEAR(D[column], expected[0], 1e-13);
        EXPECT_NEAR(D[column + 1], expected[1], 1e-13);
    }
    EXPECT_EQ(D[7], -1e300);
}

TEST_F(Functions, AttachedProbeInTheFluidSurvivesRestartAndNoticesRemoval) {
    const std::string text = "drop { type probes; fields (p); fixedLocations false; probeLocations ((0.3 0.6 0)); }";
    State<2> state = blocks(2);
    writeState(folder_.path() / "0", state);
    State<2> later = state;
    later.time = {1, 10, 0.1, 0.1};
    for (auto& x : later.nodes.x) x += Vec<2>(5, 5);
    std::swap(later.mesh.fluid.nodes.front(), later.mesh.fluid.nodes.back());  // remeshed
    auto functions = make(text, "1");
    functions.start(later);
    functions.execute(later);
    EXPECT_NEAR(rows("drop/1/p")[0][1], 10 - 1.5 + 0.6, 1e-4);
    later.nodes.id[10] = 1000;  // node at (0, 1), a corner of the triangle, was removed
    functions.execute(later);
    EXPECT_EQ(rows("drop/1/p")[1][1], -1e300);
}

TEST_F(Functions, EachHasItsOwnWriteControl) {
    auto functions = make(
        "often { type probes; fields (p); points ((0 0 0)); writeInterval 2; }"
        "seldom { type probes; fields (p); points ((0 0 0)); writeControl runTime; writeInterval 0.5; }"
        "off { type probes; enabled no; fields (p); points ((0 0 0)); }");
    State<2> state = blocks(1);
    functions.start(state);
    for (int k = 1; k <= 10; ++k) {
        state.time = {0.1 * k, k, 0.1, 0.1};
        functions.execute(state);
    }
    EXPECT_EQ(rows("often/0/p").size(), 6u);
    const auto seldom = rows("seldom/0/p");
    ASSERT_EQ(seldom.size(), 3u);
    EXPECT_EQ(seldom[1][0], 0.5);
    EXPECT_FALSE(fs::exists(folder_.path() / "postProcessing/off"));
}

TEST_F(Functions, MistakesPrintTheValidWords) {
    const std::pair<const char*, const char*> mistakes[] = {
        {"a { type massLeger; }", "massLedger"},
        {"a { type probes; fields (banana); points ((0 0 0)); }", "sigma"},
        {"a { type probes; fields (p); }", "probeLocations"},
        {"a { type probes; fields (p); points (); }", "probe"},
        {"a { type probes; fields (p); points ((0 0 0)); writeControl banana; }", "adjustableRunTime"},
        {"a 3;", "not a dictionary"},
        {"\"/tmp/a\" { type massLedger; }", "postProcessing"},
        {"\"b/a\" { type massLedger; }", "postProcessing"},
    };
    for (const auto& [text, word] : mistakes) {
        try {
            make(text);
            ADD_FAILURE() << text;
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    }
}

TEST_F(Functions, MassLedgerAddsUp) {
    State<2> state = blocks(2);
    EXPECT_DOUBLE_EQ(totalVolume<2>(state), 1.0);
    state.ledger.takeFrom({{"contact", 0.5}});  // what the mesher left there does not count
    writeState(folder_.path() / "0", state);
    auto functions = make("mass { type massLedger; }");
    functions.start(state);
    for (auto& x : state.nodes.x) x[1] *= 1.02;  // 2 % more
    state.ledger.takeFrom({{"contact", 0.515}, {"insertion", -0.001}});
    state.time = {0.1, 1, 0.1, 0.1};
    functions.execute(state);
    const auto table = rows("mass/0/fluidVolume.dat");
    ASSERT_EQ(table.size(), 2u);
    const std::vector<double> first{0, 1, 1000, 0, 0, 0, 0, 0};
    const std::vector<double> second{0.1, 1.02, 1020, 0.02, 0.015, -0.001, 0.014, 0.006};
    ASSERT_EQ(table[1].size(), second.size());
    for (std::size_t c = 0; c < second.size(); ++c) {
        EXPECT_NEAR(table[0][c], first[c], 1e-9) << c;
        EXPECT_NEAR(table[1][c], second[c], 1e-9) << c;
    }
    EXPECT_NE(readText(folder_.path() / "postProcessing/mass/0/fluidVolume.dat").find("insertion"), std::string::npos);
    // restart compares with the beginning, not with the restart
    auto restarted = make("mass { type massLedger; }", "0.1");
    restarted.start(state);
    restarted.execute(state);
    EXPECT_EQ(rows("mass/0.1/fluidVolume.dat")[0], table[1]);
}

TEST_F(Functions, MassLedgerOfAWindowGoesOnWhereTheRunBegan) {
    const std::string text = "mass { type massLedger; timeStart 0.3; }";
    State<2> state = blocks(2);
    writeState(folder_.path() / "0", state);
    make(text).start(state);
    const Dictionary dict = Dictionary::parse("functions { " + text + " }");
    for (const int k : {1, 2}) {  // restarts before the first row
        state.time = {0.1 * k, k, 0.1, 0.1};
        FunctionObjects<2> restarted(Case(folder_.path()), dict, timeName(state.time.value), 6, {}, state.time.value);
        restarted.start(state);
        state.ledger.takeFrom({{"contact", 0.01}});
        for (int i = k + 1; i <= 4; ++i) {
            state.time = {0.1 * i, i, 0.1, 0.1};
            restarted.execute(state);
        }
        EXPECT_EQ(rows("mass/0/fluidVolume.dat").size(), 2u);
        EXPECT_FALSE(fs::exists(folder_.path() / "postProcessing/mass" / timeName(0.1 * k)));
    }
}

TEST_F(Functions, MassCountsIsolatedParticles) {
    State<2> state = blocks(2);
    state.nodes.dropVolume[0] = 0.25;
    EXPECT_DOUBLE_EQ(totalVolume<2>(state), 1.25);
    EXPECT_DOUBLE_EQ(fluidMass(state, readDensities(folder_.path())), 1250);
    EXPECT_THROW(fluidMass(state, {}), UserError);
    EXPECT_EQ(fluidMass(State<2>{}, {}), 0);
}

TEST_F(Functions, FieldMinMaxFindsTheExtremes) {
    auto functions = make("extremes { type fieldMinMax; fields (p U); }");
    functions.start(blocks(4));
    const std::string text = readText(folder_.path() / "postProcessing/extremes/0/fieldMinMax.dat");
    EXPECT_NE(text.find("\n0\tp\t5\t(1 0 0)\t11\t(0 1 0)\n"), std::string::npos) << text;
}

TEST_F(Functions, TablesAreReadableWhileTheRunGoesOn) {
    auto functions = make("probes { type probes; fields (p); points ((0.5 0.25 0)); }");
    State<2> state = blocks(2);
    functions.start(state);
    for (int k = 1; k < 4; ++k) {
        state.time = {0.1 * k, k, 0.1, 0.1};
        functions.execute(state);
        EXPECT_EQ(rows("probes/0/p").size(), static_cast<std::size_t>(k + 1));
    }
}

}  // namespace pfem
