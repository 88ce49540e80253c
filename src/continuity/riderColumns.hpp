#pragma once
// What the pressure pushes on solids over which fluid slides, in the columns of its matrix.

#include <map>

#include "momentum/riderMatrix.hpp"
#include "momentum/step.hpp"

namespace pfem {

/// Derivative of the continuity equation of a node I by the solids' unknowns: B_IJ of its neighbours J that ride along,
/// and what flows through its faces on solids, int_f N_I (v_s - v) . n dS (bentWalls.hpp).
template <int Dim>
class RiderColumns {
public:
    /// `x`: of the nodes, where the fluid's domains are.
    RiderColumns(const Step<Dim>& step, const SolidDofs<Dim>& dofs, const Points<Dim>& x);

    bool any() const { return !moved_.empty(); }  // does anything ride on solids?

    /// How many of the solids' unknowns have an entry in the column of node i.
    int count(const NodeToNodes& ring, int i) const;

    /// The entries by unknowns; `nodes`: i and its neighbours, B: theirs.
    std::map<int, double> entries(int i, const std::vector<int>& nodes, const std::vector<Vec<Dim>>& B) const;

private:
    void addFlux(const Topology<Dim>& topology, const Points<Dim>& x, const FluidFace<Dim>& face);

    std::vector<std::vector<SolidVelocity<Dim>>> moved_;  // per node of the mesh
    std::vector<std::map<int, double>> flux_;             // per node, by unknowns
};

}  // namespace pfem
