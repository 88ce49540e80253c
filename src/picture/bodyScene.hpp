#pragma once
// One part of a scene: a surface with its lines, cut by a plane.

#include "picture/scene.hpp"
#include "picture/skin.hpp"

namespace pfem {

/// Which edges of a surface are drawn: its ends, where it turns away from the eye, and those sharper than `crease`
/// [degrees].
struct EdgeLook {
    Colour colour;
    double thickness;  // in pens
    double crease;
};

/// Draws surfaces of one state into a Body.
class BodyPainter {
public:
    BodyPainter(Body& body, const Points<3>& x, const Camera& camera, const std::optional<CuttingPlane>& plane)
        : body_(body), x_(x), camera_(camera), plane_(plane) {}

    int nPoints() const { return static_cast<int>(x_.size()); }

    /// `values`: per node.
    void surface(const std::vector<Face<3>>& faces, const std::vector<double>& values);
    /// The section of the plane with the cells; `mesh`: with lines of this thickness round each part.
    void section(const Cells<3>& cells, const std::vector<double>& values, double mesh);
    void edges(const std::vector<Face<3>>& faces, const EdgeLook& look);
    void everyEdge(const std::vector<Face<3>>& faces, Colour colour, double thickness);
    /// Where the plane cuts the surface.
    void traces(const std::vector<Face<3>>& faces, Colour colour, double thickness);

private:
    void add(const Corners3& polygon, bool lit);
    void add(const std::array<Vec<3>, 2>& line, Colour colour, double thickness);

    Body& body_;
    const Points<3>& x_;
    const Camera& camera_;
    const std::optional<CuttingPlane>& plane_;
};

}  // namespace pfem
