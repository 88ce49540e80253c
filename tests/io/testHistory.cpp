// The reader of postProcessing's tables.

#include "io/history.hpp"

#include <gtest/gtest.h>

#include <fstream>

using namespace pfem;

namespace {

class Tables : public testing::Test {
protected:
    std::filesystem::path put(const std::string& text) {
        auto file = std::filesystem::path(testing::TempDir()) / "pfemTable.dat";
        std::ofstream(file) << text;
        return file;
    }
};

TEST_F(Tables, headRowsAndTheirLines) {
    const auto table = readTable(put("# Fluid\n #  Time volume \n\n 0 1\n\n 0.5 2\n# later\n 1 3\n 1.5 4"));
    EXPECT_EQ(table.head.size(), 2u);
    EXPECT_EQ(table.titles(), (std::vector<std::string>{"Time", "volume"}));
    EXPECT_FALSE(table.ofProbes());
    EXPECT_EQ(table.rows, (std::vector<std::string>{" 0 1", " 0.5 2", " 1 3"}));  // the last one is not complete
    EXPECT_EQ(table.lineNumber, (std::vector<int>{4, 6, 8}));
    EXPECT_TRUE(readTable(put("# Probe 0 (1 2 0)\n#  Time\n")).ofProbes());
    EXPECT_TRUE(readTable(put("")).titles().empty());
}

TEST_F(Tables, rowsUpToATime) {
    const auto table = readTable(put("# Time\n 0 1\n 0.5 2\n 1 3\n x 4\n 1.5 5\n"));
    EXPECT_EQ(upTo(0.7, table).rows.size(), 2u);
    EXPECT_EQ(upTo(0.5, table).rows.size(), 2u);
    EXPECT_EQ(upTo(0.49999999999999, table).rows.size(), 2u);  // the row is printed with twelve digits
    EXPECT_EQ(upTo(0.499, table).rows.size(), 1u);
    EXPECT_EQ(upTo(9, table).rows.size(), 3u);  // what is no time ends it
    EXPECT_EQ(upTo(9, table).lineNumber.size(), 3u);
}

TEST_F(Tables, numbersOfARow) {
    EXPECT_EQ(numbersOf(" 0.1 (1 -2e-3 0) 7 ( 4 )", {}),
              (std::vector<std::vector<double>>{{0.1}, {1, -2e-3, 0}, {7}, {4}}));
    try {
        numbersOf("0.1 (1 a 0)", {"file", 12});
        FAIL();
    } catch (const UserError& error) {
        EXPECT_EQ(error.where().line, 12);
        EXPECT_NE(std::string(error.what()).find("'a'"), std::string::npos);
    }
}

}  // namespace
