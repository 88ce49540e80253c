#include "base/error.hpp"
#include "caseFolder.hpp"
#include "functions/sensors.hpp"

namespace pfem {

using namespace test;

TEST(Line, LinearFieldsAndTheDry) {
    const CaseFolder folder(water, tankConditions);
    State<2> state = tank();
    for (int i = 0; i < state.nodes.size(); ++i) state.nodes.v[i] = {3 * state.nodes.x[i][0], state.nodes.x[i][1]};
    state.time = {0.25, 3, 0.1, 0.1};
    auto functions =
        folder.functions("l { type line; fields (p U); start (0.2 0.1 0); end (0.6 0.7 0); nPoints 4; }", "0.1");
    functions.start(state);
    functions.execute(state);
    std::istringstream lines(folder.text("l/0.25/line_p_U.xy"));
    std::string head;
    std::getline(lines, head);
    EXPECT_EQ(head, "# distance x y z p U[0] U[1] U[2]");
    const auto rows = folder.rows("l/0.25/line_p_U.xy");
    ASSERT_EQ(rows.size(), 4u);
    for (int k = 0; k < 4; ++k) {
        const double x = 0.2 + 0.4 * k / 3, y = 0.1 + 0.6 * k / 3;
        EXPECT_NEAR(rows[k][0], std::hypot(x - 0.2, y - 0.1), 1e-9);
        EXPECT_NEAR(rows[k][2], y, 1e-9);
        EXPECT_NEAR(rows[k][4], y > 0.5 ? dry : 1e4 * (0.5 - y), 1e-6);
        EXPECT_NEAR(rows[k][5], y > 0.5 ? dry : 3 * x, 1e-9);
    }
    for (const char* text : {"fields (q); start (0 0 0); end (1 0 0);", "fields (p); start (0 0 0); end (0 0 0);",
                             "fields (p); start (0 0 0); end (1 0 0); nPoints 1;", "fields (p); end (1 0 0);"})
        EXPECT_THROW(folder.functions(std::string("l { type line; ") + text + " }"), UserError) << text;
}

TEST(BoundingBox, FluidAndSolid) {
    const CaseFolder folder(water, tankConditions);
    auto functions = folder.functions("box { type boundingBox; }");
    State<2> state = tank();
    functions.start(state);
    state.nodes.dropVolume[0] = 1e-6;
    state.nodes.x[0] = {0.5, 9};
    state.time = {1, 1, 0.1, 0.1};
    functions.execute(state);
    const auto rows = folder.rows("box/0/boundingBox.dat");
    EXPECT_NEAR(rows.at(0).at(5), 0.5, 1e-9);
    EXPECT_EQ(rows.at(0).at(7), dry);
    EXPECT_NEAR(rows.at(1).at(5), 9, 1e-9);
}

}  // namespace pfem
