#pragma once
// What motions do to the fluid's volume, by cause: into the ledger and, where somebody has asked, its fields.

#include "state/state.hpp"

namespace pfem {

/// Motions that follow each other with the same cells: the cells are summed once after each. In the fields
/// (State::appeared) each patch Omega_I = sum_e |e|/(d+1) is charged with its change.
template <int Dim>
class MotionAccount {
public:
    explicit MotionAccount(const State<Dim>& state);

    /// What has changed since the last call (or the start).
    void book(const std::string& cause, State<Dim>& state);

    /// The same of the solver. Parts of it, per node, belong to causes of their own: `returned` to `correction`,
    /// `compressed` to `compression`.
    void bookSolver(const std::vector<double>& returned, const std::vector<double>& compressed, State<Dim>& state);

private:
    /// From the cause `solver` to another one.
    double bookPart(const std::string& cause, const std::vector<double>& amounts, State<Dim>& state);
    /// The change of all cells; to the cause's field, too.
    double change(const std::string& cause, State<Dim>& state);

    double volume_;
    Points<Dim> x_;  // empty: no fields
};

}  // namespace pfem
