#include "picture/bodyScene.hpp"

#include <cmath>

namespace pfem {

namespace {

constexpr Colour meshColour{40, 40, 40};

}  // namespace

void BodyPainter::add(const Corners3& polygon, bool lit) {
    for (std::size_t k = 2; k < polygon.size(); ++k)
        body_.pieces.push_back({{polygon[0], polygon[k - 1], polygon[k]}, lit});
}

void BodyPainter::add(const std::array<Vec<3>, 2>& line, Colour colour, double thickness) {
    if (!plane_)
        body_.strokes.push_back({line, colour, thickness});
    else if (const auto left = partLeft(*plane_, line))
        body_.strokes.push_back({*left, colour, thickness});
}

void BodyPainter::surface(const std::vector<Face<3>>& faces, const std::vector<double>& values) {
    const auto normals = cornerNormals(faces, x_);
    const auto flat = faceNormals(faces, x_);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (!camera_.shows(x_[faces[f][0]], flat[f])) continue;
        Corners3 corners;
        for (std::size_t k = 0; k < 3; ++k) corners.push_back({x_[faces[f][k]], normals[f][k], values[faces[f][k]]});
        add(plane_ ? partLeft(*plane_, corners) : corners, true);
    }
}

void BodyPainter::section(const Cells<3>& cells, const std::vector<double>& values, double mesh) {
    if (!plane_) return;
    for (const auto& cell : cells.nodes) {
        std::array<Corner3, 4> corners;
        for (std::size_t k = 0; k < 4; ++k) corners[k] = {x_[cell[k]], plane_->normal, values[cell[k]]};
        const Corners3 part = pfem::section(*plane_, corners);
        add(part, false);
        for (std::size_t k = 0; mesh > 0 && k < part.size(); ++k)
            body_.strokes.push_back({{part[k].x, part[(k + 1) % part.size()].x}, meshColour, mesh});
    }
}

void BodyPainter::edges(const std::vector<Face<3>>& faces, const EdgeLook& look) {
    const Points<3> normals = faceNormals(faces, x_);
    const double least = std::cos(look.crease * 3.141592653589793 / 180);
    for (const SkinEdge& edge : skinEdges(faces)) {
        const auto [f, g] = edge.faces;
        const bool sharp = edge.count != 2 || normals[f].dot(normals[g]) < least;
        if (sharp || camera_.shows(x_[edge.a], normals[f]) != camera_.shows(x_[edge.a], normals[g]))
            add({x_[edge.a], x_[edge.b]}, look.colour, look.thickness);
    }
}

void BodyPainter::everyEdge(const std::vector<Face<3>>& faces, Colour colour, double thickness) {
    for (const SkinEdge& edge : skinEdges(faces)) add({x_[edge.a], x_[edge.b]}, colour, thickness);
}

void BodyPainter::traces(const std::vector<Face<3>>& faces, Colour colour, double thickness) {
    if (!plane_) return;
    for (const auto& [a, b, c] : faces)
        if (const auto line = trace(*plane_, {x_[a], x_[b], x_[c]}))
            body_.strokes.push_back({*line, colour, thickness});
}

}  // namespace pfem
