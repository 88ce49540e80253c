#pragma once
// What motions do to the fluid's volume, by cause.

#include "parallel/ranks.hpp"
#include "state/state.hpp"

namespace pfem {

/// Motions that follow each other with the same cells: the cells are summed once after each. In the ledger's fields
/// each patch Omega_I = sum_e |e|/(d+1) is charged with its change. By ranks that share the work.
template <int Dim>
class MotionAccount {
public:
    explicit MotionAccount(const State<Dim>& state, const Ranks& ranks = {});

    /// What has changed since the last call (or the start).
    void book(VolumeCause cause, State<Dim>& state);

    /// The same of the solver. Parts of it, per node, belong to causes of their own: `returned` to `correction`,
    /// `compressed` to `compression`.
    void bookSolver(const std::vector<double>& returned, const std::vector<double>& compressed, State<Dim>& state);

private:
    /// The change of all cells; each patch's is placed.
    double change(VolumeCause cause, State<Dim>& state);

    double volume(const State<Dim>& state) const;

    Ranks ranks_;
    double volume_;
    Points<Dim> x_;  // empty: no fields
};

}  // namespace pfem
