#include <cmath>

#include "base/error.hpp"
#include "study/history.hpp"
#include "support/folder.hpp"

namespace pfem {
namespace {

using Histories = test::Folder;

TEST_F(Histories, vectorOfOneProbeOverTwoStarts) {
    put("postProcessing/tip/0/D",
        "# Probe 0 (1 2 0)\n#       Probe  0\n#   Time\n 0 (0 0 0)\n 0.1 (1e-3 2 0)\n 0.2 (9 9 0)\n");
    put("postProcessing/tip/0.2/D",
        "#  Time\n 0.2 (2e-3 -3 0)\n 0.3 (4e-3 -4 0)\n 0.4 (5e-3 -");  // half a line: a run goes on
    const auto found = readHistories(root, "tip", "D");
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].name, "D_x");
    EXPECT_EQ(found[1].name, "D_y");
    EXPECT_EQ(found[1].curve.t, (std::vector<double>{0, 0.1, 0.2, 0.3}));
    EXPECT_EQ(found[1].curve.y, (std::vector<double>{0, 2, -3, -4}));
    EXPECT_EQ(found[0].curve.y.back(), 4e-3);
}

TEST_F(Histories, scalarsOfTwoProbesOneDry) {
    put("postProcessing/sensors/0/p", "# Probe 0 (0 0 0)\n# Probe 1 (0 1 0)\n#  Time\n 0 5 -1e+300\n 1 6 7\n");
    const auto found = readHistories(root, "sensors", "p");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].name, "1_p");
    EXPECT_TRUE(std::isnan(found[1].curve.y[0]));
    EXPECT_EQ(found[1].curve.y[1], 7);
}

TEST_F(Histories, titlesOfOtherTables) {
    put("postProcessing/mass/0/volume.dat", "# Fluid\n#\n#  Time  volume  mass\n 0 1 2\n 1 3 4\n");
    const auto found = readHistories(root, "mass", "volume.dat");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].name, "mass");
    EXPECT_EQ(found[1].curve.y, (std::vector<double>{2, 4}));
    EXPECT_EQ(historyFiles(root, "mass"), std::vector<std::string>{"volume.dat"});
}

TEST_F(Histories, badInput) {
    put("postProcessing/tip/0/D", "# Time\n 0 (0 0 0)\n 0.1 (a 2 0)\n");
    try {
        readHistories(root, "tip", "D");
        FAIL();
    } catch (const UserError& error) {
        EXPECT_EQ(error.where().line, 3);
        EXPECT_NE(std::string(error.what()).find("'a'"), std::string::npos);
    }
    put("postProcessing/empty/0/D", "# Time\n");
    EXPECT_THROW(readHistories(root, "empty", "D"), UserError);
    EXPECT_THROW(readHistories(root, "none", "D"), UserError);
    EXPECT_THROW(historyFiles(root, "none"), UserError);
}

}  // namespace
}  // namespace pfem
