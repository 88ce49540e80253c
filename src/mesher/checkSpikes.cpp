#include <cmath>

#include "mesher/checks.hpp"
#include "mesher/chords.hpp"

namespace pfem {

namespace {

constexpr double leastAngle = 0.05;  // between edges that meet: its sine

}  // namespace

void checkSpikes(const MeshDescription& mesh, const Arrangement& arrangement, const BoundaryNodes& boundary) {
    const Names names(mesh, arrangement);
    const Chords chords(boundary);
    const auto& x = boundary.x;
    for (int i = 0; i < static_cast<int>(x.size()); ++i)
        for (const int k : chords.at[i])
            for (const int l : chords.at[i]) {
                if (k >= l) continue;
                const Vec<2> u = x[chords.all[k].otherEnd(i)] - x[i], v = x[chords.all[l].otherEnd(i)] - x[i];
                const double sine = std::abs(u.x() * v.y() - u.y() * v.x()) / (u.norm() * v.norm());
                if (u.dot(v) <= 0 || sine >= leastAngle) continue;
                const int p = chords.all[k].piece, q = chords.all[l].piece;
                const double degrees = std::asin(sine) * 180 / M_PI;
                if (names.sameOutline(p, q))
                    throw UserError(
                        fmt::format(
                            "The outline of {} has a spike of {:.2g} degrees at its {}: too sharp for a triangle. "
                            "Leave it out or make it wider.",
                            names.title(p), degrees, names.point(p, x[i])),
                        names.place(p));
                throw UserError(fmt::format("{} ({}) and {} ({}) meet at ({:.9g} {:.9g}) at an angle of {:.2g} "
                                            "degrees: too sharp for a triangle",
                                            names.title(p), names.edge(p), names.title(q), names.edge(q), x[i].x(),
                                            x[i].y(), degrees),
                                names.place(std::max(p, q)));
            }
}

}  // namespace pfem
