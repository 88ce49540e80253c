// Functions of time: value, derivative and integral of every type against closed forms; mistakes with their line.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "dictionary/function1.hpp"

using namespace pfem;

namespace {

using Vector = Eigen::Vector3d;
constexpr double pi = std::numbers::pi;

Function1Ptr<double> scalar(const std::string& entry) {
    return readFunction1<double>(Dictionary::parse("f " + entry, "file"), "f");
}
Function1Ptr<Vector> vector(const std::string& entry) {
    return readFunction1<Vector>(Dictionary::parse("f " + entry, "file"), "f");
}

/// f and its derivative and integral from 0.3 at times before, between and after the points of tables.
template <class F, class D, class I>
void expectFunction(const std::string& entry, F f, D derivative, I antiderivative, double tolerance = 1e-12) {
    const auto function = scalar(entry);
    for (const double t : {0.0, 0.3, 0.77, 1.6, 2.9, 7.5}) {
        EXPECT_NEAR(function->value(t), f(t), tolerance) << entry << t;
        EXPECT_NEAR(function->derivative(t), derivative(t), std::max(tolerance, 1e-12)) << entry << t;
        EXPECT_NEAR(function->integral(0.3, t), antiderivative(t) - antiderivative(0.3), tolerance) << entry << t;
    }
}

TEST(Function1, constant) {
    for (const char* entry : {"2.5;", "constant 2.5;", "{ type constant; value 2.5; }"})
        expectFunction(
            entry, [](double) { return 2.5; }, [](double) { return 0.0; }, [](double t) { return 2.5 * t; });
}

TEST(Function1, polynomial) {
    for (const char* entry :
         {"polynomial ((3 0) (-2 1) (0.5 3));", "{ type polynomial; coeffs ((3 0) (-2 1) (0.5 3)); }"})
        expectFunction(
            entry, [](double t) { return 3 - 2 * t + 0.5 * t * t * t; }, [](double t) { return -2 + 1.5 * t * t; },
            [](double t) { return 3 * t - t * t + 0.125 * t * t * t * t; }, 1e-10);
}

TEST(Function1, derivativeOfFormulasInAllUnitsOfTime) {
    for (const double unit : {1e-9, 1e-6, 1e-3, 1.0, 60.0, 3600.0, 1e6})  // of a sine with this period
        for (const double turns : {0.0, 0.1, 0.73, 12.4, 1000.3}) {
            const double w = 2 * pi / unit, t = turns * unit;
            const auto f = scalar("expression \"0.3*sin(2*pi*t/" + fmt::format("{:g}", unit) + ")\";");
            EXPECT_NEAR(f->derivative(t), 0.3 * w * std::cos(2 * pi * turns), 1e-6 * w) << unit << " " << turns;
        }
    EXPECT_NEAR(scalar("expression \"sqrt(1 - t)\";")->derivative(0.99), -5, 1e-6);  // no value after t = 1
    EXPECT_NEAR(scalar("expression \"min(t, 0.5)\";")->derivative(0.5 + 1e-4), 0, 1e-12);
    EXPECT_NEAR(scalar("expression \"3*t\";")->derivative(7), 3, 1e-11);
    EXPECT_EQ(scalar("expression \"4\";")->derivative(7), 0);
}

TEST(Function1, expression) {
    for (const char* entry :
         {"expression \"0.2*sin(3*t) + t^2\";", "{ type expression; expression \"0.2*sin(3*t) + t^2\"; }"})
        expectFunction(
            entry, [](double t) { return 0.2 * std::sin(3 * t) + t * t; },
            [](double t) { return 0.6 * std::cos(3 * t) + 2 * t; },
            [](double t) { return -0.2 / 3 * std::cos(3 * t) + t * t * t / 3; }, 3e-9);
    EXPECT_NEAR(scalar("expression \"t^1.5\";")->derivative(0), 0, 0.02);  // no value before t = 0
}

TEST(Function1, sine) {
    const double omega = 2 * pi * 0.5;
    for (const char* entry : {"{ type sine; frequency 0.5; start 0.2; amplitude 3; scale 2; level 1; }",
                              "{ type sine; period 2; t0 0.2; amplitude constant 3; scale 2; level 1; }"})
        expectFunction(
            entry, [&](double t) { return 1 + 6 * std::sin(omega * (t - 0.2)); },
            [&](double t) { return 6 * omega * std::cos(omega * (t - 0.2)); },
            [&](double t) { return t - 6 / omega * std::cos(omega * (t - 0.2)); }, 1e-10);
    const auto growing = scalar("{ type sine; frequency 0.5; amplitude polynomial ((1 1)); }");  // t sin(pi t)
    EXPECT_NEAR(growing->value(0.7), 0.7 * std::sin(0.7 * pi), 1e-14);
    EXPECT_NEAR(growing->derivative(0.7), std::sin(0.7 * pi) + 0.7 * pi * std::cos(0.7 * pi), 1e-13);
}

TEST(Function1, square) {
    const auto f = scalar("{ type square; frequency 0.5; markSpace 3; scale 2; level 0.5; }");  // up for 1.5 s of 2 s
    for (const double t : {0.1, 1.4, 2.1, 3.4}) EXPECT_EQ(f->value(t), 2.5);
    for (const double t : {1.6, 1.9, 3.6}) EXPECT_EQ(f->value(t), -1.5);
    EXPECT_EQ(f->derivative(0.7), 0);
    EXPECT_NEAR(f->integral(0, 2), 1.5 * 2.5 - 0.5 * 1.5, 0.03);
}

TEST(Function1, scale) {
    expectFunction(
        "{ type scale; scale polynomial ((1 1)); value polynomial ((2 1) (1 0)); }",
        [](double t) { return 2 * t * t + t; }, [](double t) { return 4 * t + 1; },
        [](double t) { return 2 * t * t * t / 3 + t * t / 2; }, 1e-10);
}

// 0 at t = 0, up to 2 at t = 1, down to 1 at t = 3.
const std::string points = "((0 0) (1 2) (3 1))";
double ramp(double t) { return t < 1 ? 2 * t : 2.5 - 0.5 * t; }
double slope(double t) { return t < 1 ? 2 : -0.5; }
double area(double t) { return t < 1 ? t * t : 1 + 2.5 * (t - 1) - 0.25 * (t * t - 1); }

TEST(Function1, tableClamped) {
    for (const std::string& entry : {"table " + points + ";", "{ type table; values " + points + "; }"})
        expectFunction(
            entry, [](double t) { return t > 3 ? 1 : ramp(t); }, [](double t) { return t > 3 ? 0 : slope(t); },
            [](double t) { return t > 3 ? area(3) + t - 3 : area(t); });
    EXPECT_EQ(scalar("table " + points + ";")->value(-1), 0);
    EXPECT_EQ(scalar("table " + points + ";")->derivative(1), -0.5);  // of the piece that follows
    EXPECT_EQ(scalar("table ((1 7));")->value(3), 7);
}

TEST(Function1, tableRepeated) {
    const auto cycles = [](double t) { return std::floor(t / 3); };
    const auto inside = [](double t) { return t - 3 * std::floor(t / 3); };
    expectFunction(
        "{ type table; values " + points + "; outOfBounds repeat; }", [&](double t) { return ramp(inside(t)); },
        [&](double t) { return slope(inside(t)); }, [&](double t) { return cycles(t) * area(3) + area(inside(t)); });
}

TEST(Function1, tableFile) {
    const auto folder = std::filesystem::temp_directory_path() / ("pfemFunction1." + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "path.dat") << "(\n(0 (0 0 0)) // start\n(2 (0.5 0 -1))\n)\n";
    std::ofstream(folder / "case") << "f { type tableFile; file \"path.dat\"; }";
    const auto f = readFunction1<Vector>(Dictionary::read(folder / "case"), "f");
    EXPECT_EQ(f->value(1), Vector(0.25, 0, -0.5));
    EXPECT_EQ(f->derivative(1), Vector(0.25, 0, -0.5));
    EXPECT_EQ(f->integral(0, 2), Vector(0.5, 0, -1));
    std::filesystem::remove_all(folder);
}

TEST(Function1, vectors) {
    for (const char* entry : {"(1 2 3);", "constant (1 2 3);", "{ type constant; value (1 2 3); }"})
        EXPECT_EQ(vector(entry)->value(4), Vector(1, 2, 3)) << entry;
    EXPECT_EQ(vector("table ((0 (0 0 0)) (2 (1 2 3)));")->value(1), Vector(0.5, 1, 1.5));
    EXPECT_EQ(vector("polynomial (((1 0 2) (2 0 1)));")->value(3), Vector(9, 0, 6));
    EXPECT_EQ(vector("polynomial (((1 0 2) (2 0 1)));")->derivative(3), Vector(6, 0, 2));
    EXPECT_EQ(vector("expression (\"t\" \"2*t\" \"0\");")->value(3), Vector(3, 6, 0));
    EXPECT_LT(
        (vector("{ type sine; frequency 1; scale (0.1 0 0.2); level (1 0 0); }")->value(0.25) - Vector(1.1, 0, 0.2))
            .norm(),
        1e-15);
    EXPECT_EQ(vector("{ type scale; scale table ((0 0) (1 1)); value (2 0 0); }")->value(0.5), Vector(1, 0, 0));
}

void expectError(const std::string& entry, int line, const std::string& part) {
    try {
        scalar(entry)->value(9);
        FAIL() << entry;
    } catch (const UserError& error) {
        EXPECT_EQ(error.where().file, "file") << entry;
        EXPECT_EQ(error.where().line, line) << entry;
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(Function1, mistakes) {
    expectError("tabel ((0 0));", 1, "tableFile");
    expectError("\n{ type sinus; }", 2, "sine");
    expectError("sine 3;", 1, "entries of its own");
    expectError("{\n type sine;\n frequency 0; }", 3, "positive");
    expectError("{\n type sine;\n frequency 1;\n period 2; }", 4, "either");
    expectError("{ type sine; }", 1, "frequency");
    expectError("table ();", 1, "at least one point");
    expectError("table ((0 0) (1 1) (1 2));", 1, "ascend");
    expectError("{ type table; values ((0 0) (1 1)); outOfBounds error; }", 1, "outside the table's range");
    expectError("{ type table; values ((0 0) (1 1)); outOfBounds warn; }", 1, "clamp");
    expectError("expression \"0.1*sin(x)\";", 1, "x");
    expectError("expression \"log(9 - t)\";", 1, "finite");
    expectError("polynomial ((1));", 1, "");
    expectError("3 4;", 1, "");
    expectError("{ type tableFile;\n file \"no/such/file\"; }", 2, "no/such/file");
    EXPECT_THROW(vector("expression (\"t\" \"0\");"), UserError);
    EXPECT_THROW(vector("{ type sine; frequency 1; }"), UserError);  // scale is the direction
}

// A plane case heeds no z: whatever the function's type, one that has it is refused at its line.
TEST(Function1, zOfAPlaneCase) {
    const auto line = [](const std::string& entry) {
        try {
            readPlaneFunction1(Dictionary::parse("\nf " + entry, "file"), "f");
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find("z component"), std::string::npos) << error.what();
            return error.where().line;
        }
        return 0;
    };
    for (const char* z : {"0", "-9.81"}) {
        const int expected = z == std::string("0") ? 0 : 2;
        const auto with = [&](std::string entry) { return entry.replace(entry.find('#'), 1, z); };
        for (const char* entry : {"(1 0 #);", "constant (1 0 #);", "{ type constant; value (1 0 #); }",
                                  "table ((0 (1 0 0)) (1 (0 0 #)));", "polynomial (((1 0 #) (0 0 2)));",
                                  "expression (\"t\" \"0\" \"#*t\");", "{ type sine; frequency 1; scale (1 0 #); }",
                                  "{ type square; frequency 1; scale (1 0 0); level (0 0 #); }",
                                  "{ type scale; scale table ((0 0) (1 1)); value (1 0 #); }"})
            EXPECT_EQ(line(with(entry)), expected) << with(entry);
    }
}

}  // namespace
