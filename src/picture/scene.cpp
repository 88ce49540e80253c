#include "picture/scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/adjacency.hpp"
#include "mesh/sortedFace.hpp"
#include "picture/bodyScene.hpp"

namespace pfem {

namespace {

constexpr Colour plainFluid{78, 146, 208};
constexpr Colour plainSolid{236, 196, 148};
constexpr Colour plainWall{240, 240, 238};
constexpr Colour meshColour{40, 40, 40};
constexpr double plainShade = 0.4, colouredShade = 0.28;  // the scale's colours are to be told apart
constexpr EdgeLook fluidEdges{{28, 62, 100}, 0.7, 180};   // only where it turns away from the eye
constexpr EdgeLook solidEdges{{110, 45, 5}, 1.2, 40};
constexpr EdgeLook weveryEdge{{90, 90, 90}, 0.8, 30};

std::vector<Face<3>> boundaryOf(const Cells<3>& cells, int nNodes) {
    std::vector<Face<3>> faces;
    for (const auto& face : boundaryFaces<3>(cells.nodes, nodeToCells<3>(cells.nodes, nNodes)))
        faces.push_back(face.nodes);
    return faces;
}

/// Faces of patches that are not of a body, with the normal to where fluid may be.
std::vector<Face<3>> wallsOf(const Mesh<3>& mesh, const std::vector<Face<3>>& solid) {
    std::set<Face<3>> ofSolid;
    for (const auto& face : solid) ofSolid.insert(sorted<3>(face));
    std::vector<Face<3>> walls;
    for (const auto& patch : mesh.patches)
        for (const auto& face : patch.faces)
            if (ofSolid.count(sorted<3>(face)) == 0) walls.push_back({face[0], face[2], face[1]});
    return walls;
}

std::vector<double> fractions(const State<3>& state, const PanelStyle<3>& style) {
    std::vector<double> result(state.nodes.size(), 0.0);
    if (style.field->value)
        for (int i = 0; i < state.nodes.size(); ++i)
            result[i] = (style.field->value(state.nodes, i) - style.range.low) / (style.range.high - style.range.low);
    return result;
}

std::vector<Ball> dropsOf(const State<3>& state, const std::vector<double>& values,
                          const std::optional<CuttingPlane>& plane) {
    std::vector<Ball> balls;
    for (int i = 0; i < state.nodes.size(); ++i)
        if (const double volume = state.nodes.dropVolume[i];
            volume > 0 && !(plane && plane->beyond(state.nodes.x[i]) >= 0))
            balls.push_back({state.nodes.x[i], std::cbrt(0.75 * volume / 3.141592653589793), values[i]});
    return balls;
}

/// `painter` of the scene's walls.
void addWalls(Scene& scene, BodyPainter painter, const std::vector<Face<3>>& walls, WallLook look) {
    const std::vector<double> none(static_cast<std::size_t>(painter.nPoints()), 0.0);
    scene.walls.plain = plainWall;
    scene.walls.shade = 0.15;
    painter.edges(walls, weveryEdge);
    painter.traces(walls, weveryEdge.colour, weveryEdge.thickness);
    if (look == WallLook::outline) return;
    painter.surface(walls, none);
    if (look != WallLook::translucent) return;
    std::vector<Face<3>> backs;
    for (const auto& face : walls) backs.push_back({face[0], face[2], face[1]});
    painter.surface(backs, none);
    scene.panes.swap(scene.walls.pieces);
}

}  // namespace

const std::vector<std::string>& wallLooks() {
    static const std::vector<std::string> words{"inside", "translucent", "outline", "none"};
    return words;
}

Scene makeScene(const State<3>& state, const PanelStyle<3>& style, const SpaceOptions& options, const Camera& camera) {
    const std::vector<double> values = fractions(state, style);
    Scene scene;
    const auto paint = [&](Body& body, const Cells<3>& cells, const std::vector<Face<3>>& faces, const EdgeLook& look) {
        body.shade = body.coloured ? colouredShade : plainShade;
        BodyPainter painter(body, state.nodes.x, camera, options.plane);
        painter.surface(faces, values);
        painter.section(cells, values, style.mesh ? 0.4 : 0);
        painter.edges(faces, look);
        painter.traces(faces, look.colour, look.thickness);
        if (style.mesh) painter.everyEdge(faces, meshColour, 0.4);
    };
    const auto ofSolid = boundaryOf(state.mesh.solid, state.nodes.size());
    scene.water.plain = plainFluid;
    scene.water.coloured = hasValues(*style.field, Region::fluid);
    paint(scene.water, state.mesh.fluid, boundaryOf(state.mesh.fluid, state.nodes.size()), fluidEdges);
    scene.water.balls = dropsOf(state, values, options.plane);
    scene.solid.plain = plainSolid;
    scene.solid.coloured = hasValues(*style.field, Region::solid);
    paint(scene.solid, state.mesh.solid, ofSolid, solidEdges);

    const bool hides = !ofSolid.empty() && scene.solid.coloured && !scene.water.coloured;
    scene.opacity = options.opacity.value_or(hides ? 0.6 : 1);

    if (options.walls != WallLook::none)
        addWalls(scene, {scene.walls, state.nodes.x, camera, options.plane}, wallsOf(state.mesh, ofSolid),
                 options.walls);
    return scene;
}

}  // namespace pfem
