// Two hundred outlines with faults that the generator knows: each is meshed, or refused for what it has, with body and
// place.

#include <fmt/format.h>

#include <functional>
#include <numbers>
#include <random>

#include "cases.hpp"
#include "mesher/crossing.hpp"

namespace pfem::testing {
namespace {

constexpr int each = 15;  // outlines of a kind
constexpr double h = 0.15;
constexpr double pi = std::numbers::pi;

class Generator {
public:
    explicit Generator(unsigned seed) : random_(seed) {}

    double real(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution<>(low, high)(random_); }

    /// About the origin, with edges of 0.4 and more.
    Points<2> star() {
        const int n = whole(5, 9);
        Points<2> x;
        for (int k = 0; k < n; ++k) x.push_back(onCircle(2 * pi * (k + real(-0.1, 0.1)) / n, real(0.8, 1)));
        return x;
    }
    static Vec<2> onCircle(double angle, double r) { return {r * std::cos(angle), r * std::sin(angle)}; }

    void shuffle(Points<2>& x) { std::shuffle(x.begin(), x.end(), random_); }

private:
    std::mt19937 random_;
};

double areaOf(const Points<2>& x) {
    double twice = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const Vec<2>&a = x[k], &b = x[(k + 1) % x.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

bool edgesCross(const Points<2>& x, std::size_t i, std::size_t j) {
    const std::size_t n = x.size();
    return crossingOf(x[i], x[(i + 1) % n], x[j], x[(j + 1) % n]).has_value();
}

bool crossesItself(const Points<2>& x) {
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = i + 2; j < x.size(); ++j)
            if ((j + 1) % x.size() != i && edgesCross(x, i, j)) return true;
    return false;
}

/// A vertex a line: vertex k of the first body on line 8 + k.
std::string bodyText(const std::string& name, const Points<2>& x, const std::string& more = "", bool solid = false) {
    std::string text = name + "\n{\n" + (solid ? "type solid; material rubber;" : "type fluid; material water;") +
                       more + " vertices\n(\n";
    for (const auto& p : x) text += fmt::format("({:.17g} {:.17g})\n", p.x(), p.y());
    return text + ");\n}\n";
}

/// What came of a dictionary.
struct Outcome {
    std::optional<MeshResult> mesh;
    std::string message;
    int line = 0;

    bool says(const std::string& part) const { return message.find(part) != std::string::npos; }
    bool warns(const std::string& part) const {
        return mesh && std::any_of(mesh->warnings.begin(), mesh->warnings.end(),
                                   [&](const auto& w) { return w.find(part) != std::string::npos; });
    }
    double worstAngle() const {
        return triangleQuality(mesh->state.nodes, mesh->state.mesh.fluid, 0, mesh->state.mesh.fluid.size()).minAngle;
    }
};

/// Every refusal names the file, a line and one of the bodies.
Outcome outcomeOf(const std::string& bodies, const std::string& walls = "") {
    Outcome outcome;
    try {
        outcome.mesh =
            meshOf("meshSize " + fmt::format("{}", h) + ";\nbodies\n{\n" + bodies + "}\nwalls\n{\n" + walls + "}\n");
        expectSound(outcome.mesh->state);
    } catch (const UserError& error) {
        outcome.message = error.what();
        outcome.line = error.where().line;
        EXPECT_NE(error.where().file.find("meshDict"), std::string::npos);
        EXPECT_GT(outcome.line, 3) << outcome.message;
        EXPECT_TRUE(outcome.says("'blob'")) << outcome.message;
    } catch (const std::exception& error) {
        ADD_FAILURE() << "not a user's error: " << error.what() << "\n" << bodies;
    }
    return outcome;
}

Outcome outcomeOf(const Points<2>& x) { return outcomeOf(bodyText("blob", x)); }

void expectMeshed(const Outcome& outcome, double area, double tolerance, double angle, const std::string& text) {
    ASSERT_TRUE(outcome.mesh) << outcome.message << "\n" << text;
    EXPECT_NEAR(outcome.mesh->bodies[0].area, area, tolerance * area) << text;
    EXPECT_GT(outcome.worstAngle(), angle) << text;
}

/// `make` is called with a generator for each of the outlines.
void forEachOutline(unsigned kind, const std::function<void(Generator&)>& make) {
    for (unsigned k = 0; k < each; ++k) {
        SCOPED_TRACE(fmt::format("kind {}, outline {}", kind, k));
        Generator generator(1000 * kind + k);
        make(generator);
    }
}

TEST(GeneratedOutlines, sound) {
    forEachOutline(0, [](Generator& g) {
        const auto x = g.star();
        const auto outcome = outcomeOf(x);
        expectMeshed(outcome, areaOf(x), 1e-12, 18, bodyText("blob", x));
        EXPECT_TRUE(outcome.mesh && outcome.mesh->warnings.empty());
    });
}

TEST(GeneratedOutlines, nearDuplicates) {
    forEachOutline(1, [](Generator& g) {
        auto x = g.star();
        const double area = areaOf(x);
        const int at = g.whole(0, static_cast<int>(x.size()) - 1);
        const int copies = g.whole(1, 3);
        const double d = std::array{0.0, 1e-14, 1e-10, 0.3e-6 * h}[static_cast<std::size_t>(g.whole(0, 3))];
        const Vec<2> corner = x[at];
        for (int k = 0; k < copies; ++k) x.insert(x.begin() + at + 1, corner + Generator::onCircle(g.real(0, 6), d));
        const auto outcome = outcomeOf(x);
        expectMeshed(outcome, area, 1e-6, 18, bodyText("blob", x));
        EXPECT_TRUE(outcome.warns(fmt::format("{} and {} (", at, at + copies)));
        EXPECT_TRUE(outcome.warns(fmt::format("meshDict:{})", 8 + at + 1)));
    });
}

TEST(GeneratedOutlines, pointsTooNear) {
    forEachOutline(2, [](Generator& g) {
        auto x = g.star();
        const double area = areaOf(x);
        const int at = g.whole(0, static_cast<int>(x.size()) - 1);
        const double d = std::pow(10, g.real(-5, -1.5)) * h;
        x.insert(x.begin() + at + 1, x[at] + Generator::onCircle(g.real(0, 6), d));
        const auto outcome = outcomeOf(x);
        if (crossesItself(x)) {  // the new point has turned the corner into a loop
            EXPECT_TRUE(outcome.mesh || outcome.says("crosses itself")) << outcome.message;
            return;
        }
        expectMeshed(outcome, area, 0.01, 15, bodyText("blob", x));
        EXPECT_TRUE(outcome.warns("outline of body 'blob' has more points"));
    });
}

/// Dense points on a smooth curve, which may be rough.
void expectDense(unsigned kind, double roughness, double angle) {
    forEachOutline(kind, [&](Generator& g) {
        const double a = g.real(0, 0.2), phase = g.real(0, 6), waves = g.whole(2, 4);
        const int n = g.whole(800, 1500);
        Points<2> x, smooth;
        for (int k = 0; k < n; ++k) {
            const double t = 2 * pi * k / n, r = 1 + a * std::cos(waves * t + phase);
            smooth.push_back(Generator::onCircle(t, r));
            x.push_back(Generator::onCircle(t, r + g.real(-roughness, roughness) * h));
        }
        const auto outcome = outcomeOf(x);
        const double area = areaOf(smooth);
        expectMeshed(outcome, area, 0.02, angle, fmt::format("{} points", n));
        EXPECT_NEAR(outcome.mesh->state.mesh.fluid.size(), area / (0.25 * std::sqrt(3.0) * h * h),
                    0.2 * area / (0.43 * h * h));
        EXPECT_TRUE(outcome.warns(fmt::format("of {} are left out", n)));
    });
}

TEST(GeneratedOutlines, thousandPoints) { expectDense(3, 0, 25); }
TEST(GeneratedOutlines, thousandRoughPoints) { expectDense(4, 0.015, 20); }

TEST(GeneratedOutlines, spikes) {
    forEachOutline(5, [](Generator& g) {
        auto x = g.star();
        const int at = g.whole(0, static_cast<int>(x.size()) - 1), next = (at + 1) % static_cast<int>(x.size());
        const Vec<2> foot = 0.5 * (x[at] + x[next]);
        const double out = g.whole(0, 1) ? 1.3 : 0.6;  // a crest or a slit
        const double width = std::array{0.0, 1e-10}[static_cast<std::size_t>(g.whole(0, 1))];
        x.insert(x.begin() + at + 1, {foot, out * foot, foot + Vec<2>(width, 0)});
        const auto outcome = outcomeOf(x);
        EXPECT_TRUE(outcome.says(fmt::format("runs back on itself at its vertex {} (", at + 2))) << outcome.message;
        EXPECT_EQ(outcome.line, 8 + at + 2);
    });
}

TEST(GeneratedOutlines, pinched) {
    forEachOutline(6, [](Generator& g) {
        Points<2> x;
        const double turn = g.real(0, 6);
        const auto add = [&](double angle, double r) { x.push_back(Generator::onCircle(turn + angle, r)); };
        const int n = g.whole(2, 4), m = g.whole(2, 4);
        add(0, 0);
        for (int k = 0; k < n; ++k) add(-0.8 + 1.6 * k / (n - 1), g.real(0.8, 1));
        add(0, 0);
        for (int k = 0; k < m; ++k) add(pi - 0.8 + 1.6 * k / (m - 1), g.real(0.8, 1));
        const auto outcome = outcomeOf(x);
        EXPECT_TRUE(outcome.says(fmt::format("its vertices 0 and {} are one point", n + 1))) << outcome.message;
        EXPECT_EQ(outcome.line, 8 + n + 1);
    });
}

TEST(GeneratedOutlines, vertexOnAnEdge) {
    forEachOutline(7, [](Generator& g) {
        const double t = g.real(0.3, 0.7);
        const auto outcome = outcomeOf(Points<2>{{0, 0}, {1, 0}, {1, 1}, {t + 0.2, 1}, {t, 0}, {t - 0.2, 1}, {0, 1}});
        EXPECT_TRUE(outcome.says("its vertex 4") && outcome.says("lies on edge 0-1")) << outcome.message;
        EXPECT_EQ(outcome.line, 12);
    });
}

TEST(GeneratedOutlines, crossing) {
    forEachOutline(8, [](Generator& g) {
        auto x = g.star();
        const int at = g.whole(0, static_cast<int>(x.size()) - 2);
        std::swap(x[at], x[at + 1]);
        ASSERT_TRUE(crossesItself(x));
        const auto outcome = outcomeOf(x);
        ASSERT_TRUE(outcome.says("crosses itself near")) << outcome.message;
        std::size_t i = 0, j = 0, ignored = 0;
        const auto edges = outcome.message.substr(outcome.message.find("edge "));
        ASSERT_EQ(std::sscanf(edges.c_str(), "edge %zu-%zu and edge %zu-%zu", &i, &ignored, &j, &ignored), 4);
        EXPECT_TRUE(edgesCross(x, i, j)) << outcome.message;
    });
}

Points<2> box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

TEST(GeneratedOutlines, holesThatTouch) {
    forEachOutline(9, [](Generator& g) {
        const int kind = g.whole(0, 3);
        const double x0 = g.real(0.3, 0.6), x1 = x0 + g.real(0.25, 0.5), y1 = kind == 1 ? 1 : g.real(0.3, 0.7);
        Points<2> hole = box(x0, 0, x1, y1);                        // on the floor; up to the surface
        if (kind == 2) hole = {{x0, 0}, {x1, y1}, {x0 - 0.1, y1}};  // on a corner
        std::string holes = " holes (a);", bodies = bodyText("a", hole, "", true);
        double area = 2 - areaOf(hole);
        if (kind == 3) {  // beside another one
            const auto other = box(x1, 0, x1 + 0.4, y1 - 0.1);
            area -= areaOf(other);
            holes = " holes (a b);";
            bodies += bodyText("b", other, "", true);
        }
        const auto outcome =
            outcomeOf(bodyText("blob", box(0, 0, 2, 1), holes) + bodies, "tank { points ((0 2) (0 0) (2 0) (2 2)); }");
        expectMeshed(outcome, area, 1e-12, 10, bodies);
    });
}

TEST(GeneratedOutlines, holesThatCross) {
    forEachOutline(10, [](Generator& g) {
        const double x0 = g.real(0.3, 1), turned = g.whole(0, 1);
        const auto hole = turned ? box(-0.3, x0 * 0.3, 0.4, x0 * 0.3 + 0.4) : box(x0, -0.3, x0 + 0.4, 0.4);
        const auto outcome =
            outcomeOf(bodyText("blob", box(0, 0, 2, 1), " holes (a);") + bodyText("a", hole, "", true));
        EXPECT_TRUE(outcome.says("body 'blob' (edge") && outcome.says("body 'a' (edge") && outcome.says("cross near"))
            << outcome.message;
    });
}

TEST(GeneratedOutlines, narrow) {
    forEachOutline(11, [](Generator& g) {
        const double gap = g.real(0.01, 0.09) * h, x0 = g.real(0.4, 0.6);
        const bool notch = g.whole(0, 1);
        const Points<2> x =
            notch ? Points<2>{{0, 0}, {1, 0}, {1, 1}, {x0 + gap, 1}, {x0 + gap, 0.4}, {x0, 0.4}, {x0, 1}, {0, 1}}
                  : Points<2>{{0, 0}, {1, 0}, {1, 1}, {x0 + 0.2, 1}, {x0, gap}, {x0 - 0.2, 1}, {0, 1}};
        const auto outcome = outcomeOf(x);
        EXPECT_TRUE(outcome.says("comes within")) << outcome.message;
        EXPECT_TRUE(outcome.says(notch ? "edge 3-4" : "edge 0-1")) << outcome.message;
    });
}

TEST(GeneratedOutlines, wallsAndBodiesThatNearlyTouch) {
    forEachOutline(12, [](Generator& g) {
        const double off = std::array{1e-9, 1e-3, 0.08}[static_cast<std::size_t>(g.whole(0, 2))] * h;
        const auto outcome = outcomeOf(bodyText("blob", box(0, 0, 1, 1)),
                                       fmt::format("tank {{ points ((0 2) (0 {0:.17g}) (1 {0:.17g}) (1 2)); }}", -off));
        EXPECT_EQ(outcome.mesh.has_value(), off < 1e-6 * h) << outcome.message;
        if (outcome.mesh) return;
        EXPECT_TRUE(outcome.says("body 'blob'") && outcome.says("wall 'tank'") &&
                    outcome.says("neither joined nor apart"))
            << outcome.message;
    });
}

// Any points in any order: nothing that crosses itself is meshed, and nothing else is said to cross itself.
TEST(GeneratedOutlines, anything) {
    forEachOutline(13, [](Generator& g) {
        for (int again = 0; again < 4; ++again) {
            Points<2> x = g.star();
            for (auto& p : x) p += Vec<2>(g.real(-0.7, 0.7), g.real(-0.7, 0.7));
            if (again % 2 == 1) g.shuffle(x);
            const auto outcome = outcomeOf(x);
            const auto text = outcome.message + "\n" + bodyText("blob", x);
            EXPECT_EQ(outcome.says("crosses itself"), crossesItself(x)) << text;
            if (crossesItself(x)) continue;
            EXPECT_EQ(outcome.says("clockwise"), areaOf(x) < 0) << text;
            if (outcome.mesh)
                EXPECT_NEAR(outcome.mesh->bodies[0].area, areaOf(x), 0.02);
            else
                EXPECT_TRUE(outcome.says("clockwise") || outcome.says("larger than body") ||
                            outcome.says("comes within") || outcome.says("spike"))
                    << text;
        }
    });
}

}  // namespace
}  // namespace pfem::testing
