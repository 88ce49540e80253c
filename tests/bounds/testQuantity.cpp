#include <sstream>

#include "bounds/plotScript.hpp"
#include "bounds/quantity.hpp"
#include "support/folder.hpp"

namespace pfem {
namespace {

using Quantities = test::Folder;

std::vector<TwinHistories> study() {
    const Curve zero{{0, 1}, {0, 0}};
    return {
        {1, {{"D_x", {{0, 1}, {0, 1.4}}}, {"D_z", zero}}, {{"D_x", {{0, 1}, {0, 0.8}}}, {"D_z", zero}}},
        {0.5, {{"D_x", {{0, 0.5, 1}, {0, 0.55, 1.1}}}, {"D_z", zero}}, {{"D_x", {{0, 1}, {0, 0.95}}}, {"D_z", zero}}}};
}

TEST_F(Quantities, tableOfTheStudy) {
    const auto found = quantitiesOf("tip", study(), {{"D_x", {{0, 0.75}, {0, 0.9}}}}, {});
    ASSERT_EQ(found.size(), 1u);  // D_z never changes
    EXPECT_EQ(found[0].name, "tip_D_x");
    EXPECT_NEAR(found[0].limit.order, 2, 1e-12);
    writeQuantity(root, found[0], 6);
    const auto table = [&](std::size_t column) {
        std::ifstream stream(root / "tip_D_x.dat");
        std::string line, last;
        while (std::getline(stream, line)) last = line;
        std::istringstream words(last);
        std::string word;
        for (std::size_t k = 0; k <= column; ++k) words >> word;
        return word;
    };
    EXPECT_EQ(table(0), "1");
    EXPECT_EQ(table(1), "0.95");
    EXPECT_EQ(table(2), "1.1");
    EXPECT_EQ(table(3), "0.15");
    EXPECT_EQ(table(4), "1");
    EXPECT_EQ(table(5), "1");
    EXPECT_EQ(table(7), "1.4");
    EXPECT_EQ(table(10), "0.95");
    EXPECT_EQ(table(11), "-");  // the reference ends before
}

TEST_F(Quantities, untilATime) {
    const auto found = quantitiesOf("tip", study(), {}, 0.5);
    EXPECT_EQ(found[0].study.t, (std::vector<double>{0, 0.5}));
    EXPECT_FALSE(found[0].reference);
}

TEST_F(Quantities, scriptNamesEveryCurve) {
    auto found = quantitiesOf("tip", study(), {{"D_x", {{0, 0.75}, {0, 0.9}}}}, {});
    const std::string script = plotScript(found[0]);
    for (const char* text :
         {"set output \"tip_D_x.png\"", "nodal, h = 0.5", "elemental, h = 1", "limit and uncertainty", "1:(v(12))"})
        EXPECT_NE(script.find(text), std::string::npos) << text << "\n" << script;
    EXPECT_EQ(script.find("set object"), std::string::npos);
    found[0].band.bracket.back() = Bracket::leaves;
    EXPECT_NE(plotScript(found[0]).find("set object 1 rectangle from 0.75"), std::string::npos);
}

}  // namespace
}  // namespace pfem
