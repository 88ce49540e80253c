#include "functions/volumeFlow.hpp"

#include "base/error.hpp"
#include "tank3.hpp"

namespace pfem {

using namespace test;

// v = (1 + 2 y, y) through x = 0.37: int_0^0.5 (1 + 2 y) dy; through y = 0.21: 0.21 m2/s of a metre; a slant line: by
// the theorem of Gauss what leaves the corner that it cuts off, less what comes in through the floor.
TEST(VolumeFlow, OfALinearFieldInThePlane) {
    State<2> state = tank();
    for (int i = 0; i < state.nodes.size(); ++i) state.nodes.v[i] = {1 + 2 * state.nodes.x[i][1], state.nodes.x[i][1]};
    EXPECT_NEAR(volumeFlow<2>(state, {{0.37, 9}, {1, 0}}), 0.75, 1e-9);
    EXPECT_NEAR(volumeFlow<2>(state, {{0.5, 0.1}, {-1, 0}}), -0.75, 1e-9);  // along edges of triangles
    EXPECT_NEAR(volumeFlow<2>(state, {{0, 0.21}, {0, 1}}), 0.21, 1e-9);
    const Vec<2> slant = Vec<2>(1, 1).normalized();  // x + y = 0.4; in through x = 0: int (1 + 2 y) dy
    EXPECT_NEAR(volumeFlow<2>(state, {{0.4, 0}, slant}), (0.4 + 0.16) + 0.08, 1e-9);
    EXPECT_EQ(volumeFlow<2>(state, {{2, 0}, {1, 0}}), 0);
}

TEST(VolumeFlow, OfALinearFieldInSpace) {
    State<3> state = tank3();
    for (int i = 0; i < state.nodes.size(); ++i)
        state.nodes.v[i] = {1 + 2 * state.nodes.x[i][2], 3, state.nodes.x[i][2]};
    EXPECT_NEAR(volumeFlow<3>(state, {{0.37, 9, 9}, {1, 0, 0}}), 0.6 * 0.75, 1e-9);
    EXPECT_NEAR(volumeFlow<3>(state, {{0.5, 0, 0}, {1, 0, 0}}), 0.6 * 0.75, 1e-9);
    EXPECT_NEAR(volumeFlow<3>(state, {{0, 0.25, 0}, {0, -1, 0}}), -3 * 0.5, 1e-9);
    EXPECT_NEAR(volumeFlow<3>(state, {{0, 0, 0.21}, {0, 0, 1}}), 0.6 * 0.21, 1e-9);
    // x + y + z = 0.4: in through x = 0 int (1 + 2 z), through y = 0 3 times its area, div v = 1 within
    const double area = 0.08, through = area + 2 * 0.4 * 0.4 * 0.4 / 6;
    EXPECT_NEAR(volumeFlow<3>(state, {{0.4, 0, 0}, Vec<3>(1, 1, 1).normalized()}),
                through + 3 * area + 0.4 * 0.4 * 0.4 / 6, 1e-9);
}

// A rate 0.75 (1 + 2 t): the trapezoidal rule is exact; a run that goes on has the same rows.
template <int Dim>
void sums(const CaseFolder& folder, State<Dim> state, const std::string& point, double expected) {
    const std::string text = "flow { type volumeFlow; point " + point + "; normal (2 0 0); }";
    const auto at = [&](int k) {
        State<Dim> now = state;
        now.time = {0.1 * k, k, 0.1, 0.1};
        for (auto& v : now.nodes.v) v = Vec<Dim>::Unit(0) * (1 + 2 * now.time.value);
        return now;
    };
    auto functions = folder.functions<Dim>(text);
    functions.start(at(0));
    for (int k = 1; k <= 5; ++k) functions.execute(at(k));
    const auto rows = folder.rows("flow/0/volumeFlow.dat");
    ASSERT_EQ(rows.size(), 6u);
    for (const auto& row : rows) {
        EXPECT_NEAR(row[1], expected * (1 + 2 * row[0]), 1e-9);
        EXPECT_NEAR(row[2], expected * (row[0] + row[0] * row[0]), 1e-9);
    }
    State<Dim> half = at(5);
    half.memory = functions.memory();
    auto rest = folder.functions<Dim>(text, "0.5");
    rest.start(half);
    rest.execute(at(6));
    EXPECT_NEAR(folder.rows("flow/0.5/volumeFlow.dat").at(0).at(2), expected * 0.96, 1e-9);
}

TEST(VolumeFlow, SumsOverTime) {
    sums<2>(CaseFolder(water, tankConditions), tank(), "(0.31 0 0)", 0.5);
    sums<3>(CaseFolder(water3, tank3Conditions, tank3Gravity), tank3(), "(0.31 0 0)", 0.3);
    const CaseFolder folder(water, tankConditions);
    for (const char* entries :
         {"normal (1 0 0);", "point (0 0 0);", "point (0 0 0); normal (0 0 0);", "point (0 0 0); normal (1 0 1);"})
        EXPECT_THROW(folder.functions("f { type volumeFlow; " + std::string(entries) + " }"), UserError) << entries;
}

}  // namespace pfem
