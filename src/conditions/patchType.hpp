#pragma once
// What a type of patch is: to the mesh, to the nodes on it, to those who write constant/boundaryConditions. A new type
// is one file that makes its PatchType, and its line in the table of patchTypes.cpp.

#include <functional>
#include <string>
#include <vector>

#include "conditions/openings.hpp"
#include "dictionary/entries.hpp"
#include "mesh/topology.hpp"

namespace pfem {

/// How a node may move.
enum class Constraint : unsigned char {
    free,
    fixed,  // clamped, or stuck to a rigid wall
    slide   // only perpendicular to its normal
};

/// What the entries of a patch say beside `type` and `motion`.
struct PatchEntries {
    Function1Ptr<Eigen::Vector3d> traction;  // load per area over time [Pa]; null: none
    double friction = 0;                   // c_f of a wall along which water slides [-], see momentum/wallFriction.hpp
    std::shared_ptr<const Inlet> inlet;    // what comes in; null: nothing
    std::shared_ptr<const Outlet> outlet;  // what lets water go; null: nothing
};

struct PatchType {
    std::string name;                           // `type` in constant/boundaryConditions
    std::string meaning;                        // for the keyword page
    PatchKind kind;                             // what the mesh sees
    bool onlyOfSolids = false;                  // not for planes that cut a body of fluid
    bool mayMove = false;                       // takes a `motion`
    bool loads = false;                         // prescribes the force on it: bears nothing
    Constraint own = Constraint::free;          // of its own nodes; those of walls are corners, which are fixed
    Constraint wet = Constraint::free;          // of fluid nodes on a wall of this type under water, and of drops
    Constraint contactLine = Constraint::free;  // of fluid nodes on it at the free surface
    std::vector<EntryDescription> entries = {};
    /// Read them; `plane`: of a case in two dimensions.
    std::function<PatchEntries(const Dictionary& entry, bool plane)> read = nullptr;

    bool has(const std::string& entry) const;
};

/// All types, in the order of the keyword page.
const std::vector<PatchType>& patchTypes();

/// Their names, of all or of those that `wanted` says yes to: "slip, noSlip" + `last` + "clamped".
std::vector<std::string> typeNames(const std::function<bool(const PatchType&)>& wanted = nullptr);
std::string typeList(const std::function<bool(const PatchType&)>& wanted, const std::string& last);

}  // namespace pfem
