#pragma once
// What the patches do: constant/boundaryConditions.

#include <algorithm>
#include <vector>

#include "conditions/damping.hpp"
#include "conditions/patchType.hpp"
#include "conditions/wallMotion.hpp"

namespace pfem {

/// One entry per patch of the mesh.
template <int Dim>
struct BoundaryConditions {
    std::vector<const PatchType*> type;  // of the table
    std::vector<PatchKind> kind;         // that of the type
    std::vector<Vec<Dim>> traction;      // [Pa]; traction patches only, at the time in question
    std::vector<Function1Ptr<Eigen::Vector3d>> tractionOverTime;  // null: it stays as it is
    std::vector<std::shared_ptr<const WallMotion>> motion;        // null: at rest; walls and clamped patches only

    std::vector<double> friction;                       // c_f of slip walls [-], see momentum/wallFriction.hpp
    std::vector<std::shared_ptr<const Inlet>> inlet;    // null: water does not come in there
    std::vector<std::shared_ptr<const Outlet>> outlet;  // null: nor does it go
    double sideFriction = 0;  // (2D) c_f over the distance of the two walls in front and behind [1/m]
    std::vector<DampingZone<Dim>> damping;

    bool anyInlet() const {
        return std::any_of(inlet.begin(), inlet.end(), [](const auto& i) { return i != nullptr; });
    }
    bool anyOutlet() const {
        return std::any_of(outlet.begin(), outlet.end(), [](const auto& o) { return o != nullptr; });
    }
    bool anyMotion() const {
        return std::any_of(motion.begin(), motion.end(), [](const auto& m) { return m != nullptr; });
    }
};

/// Read the condition of every patch: of the entry with its name, else of the last pattern that matches it. Throws
/// UserError for patches without entry, an entry without patch, and unknown types.
template <int Dim>
BoundaryConditions<Dim> readBoundaryConditions(const Dictionary& dict, const std::vector<Patch<Dim>>& patches);

}  // namespace pfem
