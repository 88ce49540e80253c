#pragma once
// Tests that are run in two and in three dimensions, and their irregular meshes.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/cases.hpp"
#include "support/cases3.hpp"

/// A suite of TYPED_TESTs whose TypeParam::value is the dimension.
#define PFEM_BOTH_DIMENSIONS(suite)        \
    template <class T>                     \
    class suite : public testing::Test {}; \
    TYPED_TEST_SUITE(suite, BothDimensions)

namespace pfem::test {

using BothDimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;

template <int Dim>
using CaseOf = std::conditional_t<Dim == 2, TestCase, TestCase3>;

using IsIn = std::function<bool(const Vec<3>&)>;

/// Conditions of the patches that the case has now, as in constant/boundaryConditions.
inline void setConditions(TestCase3& c, const std::string& text) {
    c.problem.conditions =
        readBoundaryConditions<3>(Dictionary::parse(text, "boundaryConditions"), c.state.mesh.patches);
}

/// Fluid and solid on one lattice of cubes of size h, each whose middle is in the one or the other; gravity along -z.
/// `materials`: the fluid, the solid.
inline TestCase3 onLattice(const Vec<3>& low, const Vec<3>& high, double h, const IsIn& isFluid, const IsIn& isSolid,
                           const std::string& materials) {
    TestCase3 c;
    c.problem.materials = readMaterials(Dictionary::parse(materials, "materials"));
    for (const auto& m : c.problem.materials) c.state.mesh.materials.push_back(m.name);
    addLattice(c.state, c.state.mesh.fluid, 0, low, high, h, isFluid);
    addLattice(c.state, c.state.mesh.solid, 1, low, high, h, isSolid);
    c.state.nodes.X = c.state.nodes.x;
    c.problem.gravity = {0, 0, -9.81};
    setConditions(c, "");
    return c;
}

/// A block of fluid alone, from the origin to `size`, along the last direction 0.5 m.
template <int Dim>
CaseOf<Dim> freeBlock(const std::string& material) {
    if constexpr (Dim == 2) {
        return makeCase("meshSize 0.1; bodies ( water { type fluid; material " +
                            material.substr(0, material.find(' ')) + "; " + rectangle(0, 0, 1, 0.5) + " } );",
                        material, "");
    } else {
        return onLattice(
            Vec<3>::Zero(), {0.6, 0.4, 0.5}, 0.1, [](const Vec<3>&) { return true; },
            [](const Vec<3>&) { return false; }, material);
    }
}

/// Moves all nodes by up to `shift` in each direction.
template <int Dim>
void shake(double shift, Nodes<Dim>& nodes) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(-shift, shift);
    for (auto& x : nodes.x)
        for (int d = 0; d < Dim; ++d) x[d] += value(random);
    nodes.X = nodes.x;
}

/// irregularPair() of cases.hpp; in space the unit cube of 0.25 m, its solid clamped at z = 1.
template <int Dim>
CaseOf<Dim> irregular() {
    if constexpr (Dim == 2) {
        return irregularPair();
    } else {
        TestCase3 c = onLattice(
            Vec<3>::Zero(), Vec<3>::Ones(), 0.25, [](const Vec<3>& x) { return x[2] < 0.5; },
            [](const Vec<3>& x) { return x[2] > 0.5; },
            "water { type newtonian; rho 1000; mu 3; kappa 2.1e9; }" + rubber);
        c.state.mesh.patches.push_back(solidPatch(c.state, "top", [](const Vec<3>& x) { return x[2] > 1 - 1e-9; }));
        c.problem.conditions = readBoundaryConditions<3>(
            Dictionary::parse("top { type clamped; }", "boundaryConditions"), c.state.mesh.patches);
        shake<3>(0.03, c.state.nodes);
        return c;
    }
}

template <int Dim>
void useUpdate(Problem<Dim>& problem, const std::string& update) {
    applyStressUpdate<Dim>(Dictionary::parse("solid { stressUpdate " + update + "; }", "pfemSolution"), problem);
}

/// The first Dim rows and columns of a tensor.
template <int Dim>
Tensor<Dim> corner(std::initializer_list<double> rows) {
    Tensor<3> whole;
    auto value = rows.begin();
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) whole(i, k) = *value++;
    return whole.template topLeftCorner<Dim, Dim>();
}

/// A velocity gradient without symmetry.
template <int Dim>
Tensor<Dim> someGradient() {
    return corner<Dim>({0.3, -1.2, 0.6, 0.8, 0.45, -0.7, -0.4, 0.9, -0.2});
}

/// Turn by an angle [rad], in space about an axis that is not one of the coordinates'.
template <int Dim>
Tensor<Dim> turn(double angle) {
    if constexpr (Dim == 2)
        return Eigen::Rotation2Dd(angle).toRotationMatrix();
    else
        return Eigen::AngleAxisd(angle, Vec<3>(1, -2, 0.7).normalized()).toRotationMatrix();
}

template <int Dim>
Points<Dim> someVectors(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1, 1);
    Points<Dim> v(n);
    for (auto& u : v)
        for (int d = 0; d < Dim; ++d) u[d] = value(random);
    return v;
}

inline double dot(const Points<3>& a, const Points<3>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
}

inline double largest(const Points<3>& a) {
    double m = 0;
    for (const auto& u : a) m = std::max(m, u.norm());
    return m;
}

}  // namespace pfem::test
