#include "functions/surfaces.hpp"

#include "base/error.hpp"
#include "functions/surfaceBuilder.hpp"
#include "io/surfaceFile.hpp"
#include "tank3.hpp"

namespace pfem {

using namespace test;

namespace {

template <int Dim>
std::vector<NodalField<Dim>> fieldsOf(const std::vector<std::string>& names) {
    std::vector<NodalField<Dim>> fields;
    for (const auto& name : names) fields.push_back(nodalField<Dim>(name));
    return fields;
}

/// Values that are linear in space are the same on a cut.
template <int Dim>
void expectLinear(const State<Dim>& state, const Plane<Dim>& plane) {
    const FieldSurface cut = cutSurface<Dim>(state, plane, fieldsOf<Dim>({"p", "U"}));
    ASSERT_FALSE(cut.cells.empty());
    ASSERT_EQ(cut.fields.at(1).values.size(), 3 * cut.x.size());
    for (std::size_t i = 0; i < cut.x.size(); ++i) {
        const Vec<3>& x = cut.x[i];
        EXPECT_NEAR((x.head<Dim>() - plane.point).dot(plane.normal), 0, 1e-12);
        EXPECT_NEAR(cut.fields[0].values[i], 1e4 * (0.5 - x[Dim - 1]), 1e-8);
        EXPECT_NEAR(cut.fields[1].values[3 * i], 1 + 2 * x[1], 1e-12);
        EXPECT_NEAR(cut.fields[1].values[3 * i + 1], -x[0], 1e-12);
        EXPECT_EQ(cut.fields[1].values[3 * i + 2], 0);
    }
}

/// v = (1 + 2 y, -x)
template <int Dim>
State<Dim> sheared(State<Dim> state) {
    for (int i = 0; i < state.nodes.size(); ++i) {
        state.nodes.v[i].setZero();
        state.nodes.v[i].template head<2>() = Vec<2>(1 + 2 * state.nodes.x[i][1], -state.nodes.x[i][0]);
    }
    return state;
}

}  // namespace

TEST(Surfaces, CutsInThePlane) {
    const State<2> state = sheared(tank());
    const auto length = [&](const Plane<2>& plane) { return sizeOf(cutSurface<2>(state, plane, {})); };
    EXPECT_NEAR(length({{0.37, 0}, {1, 0}}), 0.5, 1e-9);
    EXPECT_NEAR(length({{0.5, 0}, {1, 0}}), 0.5, 1e-9);
    EXPECT_NEAR(length({{0.4, 0}, Vec<2>(1, 1).normalized()}), 0.4 * std::sqrt(2), 1e-9);
    EXPECT_EQ(length({{1.5, 0}, {1, 0}}), 0);
    expectLinear<2>(state, {{0.37, 0}, {1, 0}});
    expectLinear<2>(state, {{0.4, 0}, Vec<2>(1, 3).normalized()});
}

TEST(Surfaces, CutsInSpace) {
    for (const double jitter : {0.0, 0.2}) {
        const State<3> state = sheared(tank3(0.1, jitter));
        const auto area = [&](const Plane<3>& plane) { return sizeOf(cutSurface<3>(state, plane, {})); };
        EXPECT_NEAR(area({{0.37, 0, 0}, {1, 0, 0}}), 0.3, 1e-9);
        EXPECT_NEAR(area({{0.5, 0, 0}, {-1, 0, 0}}), 0.3, 1e-9);  // through the nodes where there is no jitter
        EXPECT_NEAR(area({{0, 0.3, 0}, {0, 1, 0}}), 0.5, 1e-9);
        EXPECT_NEAR(area({{0.4, 0, 0}, Vec<3>(1, 1, 1).normalized()}), std::sqrt(3) / 2 * 0.16, 1e-9);
        expectLinear<3>(state, {{0.37, 0, 0}, {1, 0, 0}});
        expectLinear<3>(state, {{0.4, 0, 0}, Vec<3>(1, -2, 3).normalized()});
        const Vec<3> normal = Vec<3>(1, -2, 3).normalized();
        const FieldSurface cut = cutSurface<3>(state, {{0.4, 0.3, 0.2}, normal}, {});
        for (const auto& cell : cut.cells) {  // all turn right about the normal
            const Vec<3> a = cut.x[cell[0]], b = cut.x[cell[1]] - a, c = cut.x[cell.back()] - a;
            EXPECT_GE(b.cross(c).dot(normal), -1e-15);
        }
    }
}

// A cube of rubber beside a cube of water: what belongs to whom.
TEST(Surfaces, FluidAndSolid) {
    State<3> state;
    state.mesh.materials = {"water", "rubber"};
    addLattice(state, state.mesh.fluid, 0, {0, 0, 0}, {1, 1, 1}, 0.5);
    addLattice(state, state.mesh.solid, 1, {1, 0, 0}, {2, 1, 1}, 0.5);
    for (int i = 0; i < state.nodes.size(); ++i) {
        state.nodes.p[i] = 5;
        state.nodes.sigma[i] << 1, 2, 3, 4, 5, 6;  // xx yy zz xy yz xz
    }
    const FieldSurface cut = cutSurface<3>(state, {{0, 0.3, 0}, {0, 1, 0}}, fieldsOf<3>({"p", "sigma"}));
    EXPECT_NEAR(sizeOf(cut), 2, 1e-12);
    EXPECT_EQ(cut.materials, state.mesh.materials);
    for (std::size_t e = 0; e < cut.cells.size(); ++e)
        for (const int i : cut.cells[e]) {
            const bool solid = cut.material[e] == 1;
            EXPECT_TRUE(solid ? cut.x[i][0] >= 1 : cut.x[i][0] <= 1) << cut.x[i][0];
            EXPECT_EQ(cut.fields[0].values[i], solid ? 0 : 5);
            for (int c = 0; c < 6; ++c) EXPECT_EQ(cut.fields[1].values[6 * i + c], solid ? c + 1 : 0);
        }
}

TEST(Surfaces, FilesOfARunInSpace) {
    const std::string rubber = "rubber { type hypoelastic; rho 1000; E 1e6; nu 0.3; }";
    const CaseFolder folder(water3 + rubber, tank3Conditions, tank3Gravity);
    State<3> state = tank3();
    state.mesh.materials.emplace_back("rubber");
    addLattice(state, state.mesh.solid, 1, {0.2, 0.2, 1}, {0.4, 0.5, 1.2}, 0.1);
    const std::string text =
        "s { type surfaces; fields (p U D); planes (((0.37 0 0) (2 0 0)) ((0 0.3 0) (0 -1 0))); freeSurface yes; "
        "solidSkin yes; }";
    auto functions = folder.functions<3>(text);
    functions.start(state);
    state.time = {0.25, 3, 0.1, 0.1};
    functions.execute(state);
    const auto area = [&](const std::string& file) {
        const TriSurface surface = readVtp(folder.path() / "postProcessing/s" / file);
        double sum = 0;
        for (const auto& t : surface.triangles)
            sum += 0.5 * (surface.x[t[1]] - surface.x[t[0]]).cross(surface.x[t[2]] - surface.x[t[0]]).norm();
        return sum;
    };
    for (const std::string time : {"0/", "0.25/"}) {
        EXPECT_NEAR(area(time + "plane0.vtp"), 0.3 + 0.06, 1e-9);
        EXPECT_NEAR(area(time + "plane1.vtp"), 0.5 + 0.04, 1e-9);
        EXPECT_NEAR(area(time + "freeSurface.vtp"), 0.6, 1e-9);
        EXPECT_NEAR(area(time + "solidSkin.vtp"), 2 * (0.06 + 0.06 + 0.04), 1e-9);
    }
    const std::string series = folder.text("s/plane1.vtp.series");
    EXPECT_EQ(series,
              "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n"
              "    { \"name\" : \"0/plane1.vtp\", \"time\" : 0 },\n"
              "    { \"name\" : \"0.25/plane1.vtp\", \"time\" : 0.25 }\n  ]\n}\n");
}

// What comes after the time at which a run goes on is of the run before.
TEST(Surfaces, TheListAfterARestart) {
    const CaseFolder folder(water, tankConditions);
    const auto root = folder.path() / "postProcessing/s";
    const auto surface = cutSurface<2>(tank(), {{0.37, 0}, {1, 0}}, fieldsOf<2>({"p"}));
    SurfaceSeries whole(root, "plane0", {});
    for (const double time : {0.0, 0.1, 0.2, 0.3}) whole.add(surface, time);
    const std::string list = folder.text("s/plane0.vtp.series"), bytes = folder.text("s/0.2/plane0.vtp");
    SurfaceSeries rest(root, "plane0", 0.1 + 1e-16);
    rest.add(surface, 0.2);
    EXPECT_EQ(folder.text("s/plane0.vtp.series").find("0.3"), std::string::npos);
    rest.add(surface, 0.3);
    EXPECT_EQ(folder.text("s/plane0.vtp.series"), list);
    EXPECT_EQ(folder.text("s/0.2/plane0.vtp"), bytes);
}

TEST(Surfaces, MistakesAreNamed) {
    const CaseFolder folder(water, tankConditions);
    for (const char* entries :
         {"fields (p);", "fields (q); freeSurface yes;", "freeSurface yes;", "fields (p); planes (((0 0 0)));",
          "fields (p); planes (((0 0 0) (0 0 0)));", "fields (p); planes (((0 0 0) (1 0 1)));"})
        EXPECT_THROW(folder.functions("s { type surfaces; " + std::string(entries) + " }"), UserError) << entries;
    auto functions = folder.functions("s { type surfaces; fields (p); freeSurface yes; }");
    functions.start(tank());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "postProcessing/s/0/freeSurface.vtp"));
}

}  // namespace pfem
