// The same bodies in other units of length: the same mesh. Where lengths fit (points of the lattice just as far from
// the sides as is allowed, corners of rectangles and trapezoids on one circle, seven and a half edges on a side),
// round-off must not choose.

#include "cases.hpp"

namespace pfem::testing {
namespace {

MeshDescription inUnits(MeshDescription mesh, double scale) {
    const auto convert = [&](Outline& outline) {
        for (auto& x : outline.points) x *= scale;
        for (auto& arc : outline.arcs) arc.through *= scale;
        outline.meshSize *= scale;
    };
    for (auto& body : mesh.bodies) convert(body);
    for (auto& wall : mesh.walls) convert(wall);
    for (auto& place : mesh.refinements) {
        for (auto& x : place.points) x *= scale;
        place.distance *= scale;
        place.meshSize *= scale;
    }
    mesh.meshSize *= scale;
    return mesh;
}

void expectSameMesh(const MeshDescription& description) {
    const State<2> metres = buildMesh(description).state;
    for (const double scale : {1000.0, 100.0, 1 / 0.0254, 1 / 0.3048, 0x1p-10}) {
        const State<2> other = buildMesh(inUnits(description, scale)).state;
        ASSERT_EQ(metres.nodes.id, other.nodes.id) << scale;
        EXPECT_EQ(metres.mesh.fluid.nodes, other.mesh.fluid.nodes) << scale;
        EXPECT_EQ(metres.mesh.solid.nodes, other.mesh.solid.nodes) << scale;
        EXPECT_EQ(metres.nodes.wall, other.nodes.wall) << scale;
        for (int i = 0; i < metres.nodes.size(); ++i)
            ASSERT_LT((scale * metres.nodes.x[i] - other.nodes.x[i]).norm(), 1e-9 * other.nodes.h[i]) << scale;
    }
}

TEST(Units, sizesOfTheDamBreak) {
    for (const double size : {0.003, 0.0045, 0.009, 0.012}) {
        SCOPED_TRACE(size);
        expectSameMesh(describe(damBreakElasticWall(), size));
    }
}

TEST(Units, curvedBodiesHolesAndOtherSizes) {
    for (const auto& text : {elasticContainer(), hydrostaticPlate(), cylinder()}) expectSameMesh(describe(text));
}

TEST(Units, halfAnEdgeMoreOrLess) {  // 7.5 and 3.5 edges on the sides, and a place of finer mesh
    expectSameMesh(describe(
        dictOf(fluidBody("water", "(0 0) (0.3 0) (0.3 0.14) (0 0.14)") +
                   solidBody("block", "(0.3 0) (0.7 0) (0.7 0.14) (0.3 0.14)", "meshSize 0.02; pattern checkerboard;"),
               "tank { points ((0 1) (0 0) (1 0) (1 1)); }", "0.04") +
        "refinements { corner { type box; min (0 0); max (0.1 0.1); meshSize 0.02; } }"));
}

}  // namespace
}  // namespace pfem::testing
