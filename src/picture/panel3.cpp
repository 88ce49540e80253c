#include "picture/panel3.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "picture/render.hpp"

namespace pfem {

namespace {

constexpr double huge = std::numeric_limits<double>::max();

/// f(x) for all points that are to be seen.
template <class F>
void forPoints(const std::vector<State<3>>& states, const SpaceOptions& options, const F& f) {
    if (options.box) {
        for (int k = 0; k < 8; ++k) {
            Vec<3> corner;
            for (int d = 0; d < 3; ++d) corner[d] = (*options.box)[(k >> d) & 1][d];
            f(corner);
        }
        return;
    }
    for (const auto& state : states) {
        for (const auto* cells : {&state.mesh.fluid, &state.mesh.solid})
            for (const auto& cell : cells->nodes)
                for (const int i : cell) f(state.nodes.x[i]);
        if (options.walls == WallLook::none) continue;
        for (const auto& patch : state.mesh.patches)
            for (const auto& face : patch.faces)
                for (const int i : face) f(state.nodes.x[i]);
    }
}

}  // namespace

Framing framingOf(const std::vector<State<3>>& states, const SpaceOptions& options) {
    Vec<3> low = Vec<3>::Constant(huge), high = -low;
    forPoints(states, options, [&](const Vec<3>& x) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    });
    const double radius = 0.5 * (high - low).norm();
    if (!(low[0] <= high[0]) || !(radius > 0) || !std::isfinite(radius))
        throw UserError("the selected times hold nothing that can be drawn");
    Framing framing{Camera(options.view, 0.5 * (low + high), radius),
                    {Vec<2>::Constant(huge), Vec<2>::Constant(-huge)}};
    Window& window = framing.window;
    forPoints(states, options, [&](const Vec<3>& x) {
        const Vec<2> place = framing.camera.see(x).place;
        window = {window.low.cwiseMin(place), window.high.cwiseMax(place)};
    });
    const Vec<2> margin = Vec<2>::Constant(0.03 * window.size().maxCoeff());
    window = {window.low - margin, window.high + margin};
    return framing;
}

void drawPanel(Canvas& canvas, const Box& box, const Framing& framing, const Scene& scene, const PanelStyle<3>& style) {
    const int left = static_cast<int>(std::floor(box.left)), top = static_cast<int>(std::floor(box.top));
    const int fine = canvas.format() == PictureFormat::png ? 1 : 2;
    Screen screen;
    screen.width = fine * static_cast<int>(std::ceil(box.width()));
    screen.height = fine * static_cast<int>(std::ceil(box.height()));
    screen.scale = fine * box.width() / framing.window.size()[0];
    screen.origin = {fine * (box.left - left) - screen.scale * framing.window.low[0],
                     fine * (box.bottom - top) + screen.scale * framing.window.low[1]};
    screen.pen = fine * style.pen;
    canvas.picture(render(scene, framing.camera, screen, style.colourOf), left, top, fine);
}

void drawAxes(Canvas& canvas, const Camera& camera, const Vec<2>& at, double length) {
    const double thickness = std::max(1.0, 0.06 * length), size = 0.4 * length;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec<3> seen = camera.turn(Vec<3>::Unit(axis));
        const Vec<2> d(seen[0], -seen[1]);
        if (d.norm() < 0.1) continue;  // it points to the eye
        canvas.line(at, at + length * d, thickness, black);
        const Vec<2> label = at + (length * d.norm() + 0.8 * size) * d.normalized();
        canvas.text(std::string(1, static_cast<char>('x' + axis)), label + Vec<2>(0, 0.4 * size), size, Align::centre);
    }
}

}  // namespace pfem
