#pragma once
// A small state with everything in it: fluid, solid, interface, walls, an isolated particle, awkward numbers.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "state/state.hpp"

namespace pfem::test {

/// A new empty folder, removed at the end of the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        static int count = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("pfemTest-" + std::to_string(getpid()) + "-" + std::to_string(count++));
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Fluid square [0,1]^2 of 2 triangles, solid square [1,2]x[0,1] of 2 triangles on its right, an isolated
/// particle, a wall node that touches no cell.
inline State<2> sampleState() {
    State<2> s;
    s.time = {0.1 + 0.2, 7, 1.0 / 3.0, 1e-3};
    s.nextId = 4000000000;
    s.approach = 1.0 / 3.0;
    s.ledger.takeFrom({{"contact", -1.0 / 7.0}, {"insertion", 0.0}, {"removal", 1e-300}});
    s.energy.takeFrom({{"remeshing", -0.1}, {"volume", 1.0 / 3.0}});
    const Points<2> x{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}, {0.3, 3.7}, {-0.5, 2}};
    s.nodes.resize(static_cast<int>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto r = static_cast<double>(i);
        s.nodes.id[i] = static_cast<Id>(i * i * 3 + i);
        s.nodes.x[i] = x[i] + Vec<2>(1e-17 * r, 0.1 / (r + 3));
        s.nodes.X[i] = x[i];
        s.nodes.v[i] = {std::sin(r), -0.0};
        s.nodes.a[i] = {std::exp(-r * 40), 1 / (r + 0.1)};
        s.nodes.p[i] = 1000.0 / 3 * r - 7;
        s.nodes.h[i] = 0.1 * r;
    }
    s.nodes.id.back() = 3999999999;
    for (const std::size_t i : {1u, 2u, 4u, 5u})
        s.nodes.sigma[i] << 1.0 / 3, -2e5 * static_cast<double>(i), 5e-324, -0.0;
    s.nodes.dropVolume[6] = 1e-5 / 3;
    s.nodes.lostVolume[2] = -1e-6 / 7;
    s.mesh.fluid = {{{0, 1, 2}, {2, 3, 0}}, {1, 0}};
    s.mesh.solid = {{{5, 1, 4}, {1, 5, 2}}, {2, 2}};
    s.mesh.solid.sigma.resize(2);  // as with elemental integration
    s.mesh.solid.sigma[0] << 1.0 / 7, 5e-324, -0.0, 3e5;
    s.mesh.solid.sigma[1] << -1e-300, 2.0 / 3, 1e300, 0.0;
    s.mesh.patches = {{"walls", {{{1, 0}}, {{0, 3}}, {{3, 7}}}}, {"nothingHere", {}}, {"clamp", {{{4, 5}}}}};
    s.mesh.materials = {"water", "oil", "rubber"};
    return s;
}

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
inline bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

inline void expectIdentical(const State<2>& a, const State<2>& b) {
    EXPECT_TRUE(sameBits(a.time.value, b.time.value));
    EXPECT_EQ(a.time.index, b.time.index);
    EXPECT_TRUE(sameBits(a.time.deltaT, b.time.deltaT));
    EXPECT_TRUE(sameBits(a.time.deltaT0, b.time.deltaT0));
    EXPECT_EQ(a.nextId, b.nextId);
    EXPECT_EQ(a.approach, b.approach);
    EXPECT_EQ(a.ledger.byName(), b.ledger.byName());
    EXPECT_EQ(a.energy.byName(), b.energy.byName());
    EXPECT_EQ(a.nodes.id, b.nodes.id);
    EXPECT_TRUE(sameBits(a.nodes.x, b.nodes.x));
    EXPECT_TRUE(sameBits(a.nodes.v, b.nodes.v));
    EXPECT_TRUE(sameBits(a.nodes.a, b.nodes.a));
    EXPECT_TRUE(sameBits(a.nodes.p, b.nodes.p));
    EXPECT_TRUE(sameBits(a.nodes.sigma, b.nodes.sigma));
    EXPECT_TRUE(sameBits(a.nodes.X, b.nodes.X));
    EXPECT_TRUE(sameBits(a.nodes.h, b.nodes.h));
    EXPECT_TRUE(sameBits(a.nodes.dropVolume, b.nodes.dropVolume));
    EXPECT_TRUE(sameBits(a.nodes.lostVolume, b.nodes.lostVolume));
    EXPECT_EQ(a.mesh.fluid.nodes, b.mesh.fluid.nodes);
    EXPECT_EQ(a.mesh.fluid.material, b.mesh.fluid.material);
    EXPECT_EQ(a.mesh.solid.nodes, b.mesh.solid.nodes);
    EXPECT_EQ(a.mesh.solid.material, b.mesh.solid.material);
    EXPECT_TRUE(sameBits(a.mesh.solid.sigma, b.mesh.solid.sigma));
    EXPECT_EQ(a.nodes.history.names, b.nodes.history.names);
    EXPECT_EQ(a.mesh.solid.history.names, b.mesh.solid.history.names);
    EXPECT_TRUE(sameBits(a.nodes.history.values, b.nodes.history.values));
    EXPECT_TRUE(sameBits(a.mesh.solid.history.values, b.mesh.solid.history.values));
    EXPECT_TRUE(sameBits(a.mesh.fluid.sigma, b.mesh.fluid.sigma));
    EXPECT_EQ(a.mesh.materials, b.mesh.materials);
    ASSERT_EQ(a.mesh.patches.size(), b.mesh.patches.size());
    for (std::size_t k = 0; k < a.mesh.patches.size(); ++k) {
        EXPECT_EQ(a.mesh.patches[k].name, b.mesh.patches[k].name);
        EXPECT_EQ(a.mesh.patches[k].faces, b.mesh.patches[k].faces);
    }
}

}  // namespace pfem::test
