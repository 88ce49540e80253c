#pragma once
// A step that cannot be accepted, with the state in which it was given up: for the repetition, the message, the eye.

#include "base/error.hpp"
#include "state/state.hpp"

namespace pfem {

/// `trial`: nodes and mesh as they were then; its numbers need not be finite, its elements may be inverted.
template <int Dim>
class FailedStep : public StepFailure {
public:
    FailedStep(const StepFailure& reason, Nodes<Dim> nodes, Mesh<Dim> mesh) : StepFailure(reason) {
        trial_.nodes = std::move(nodes);
        trial_.mesh = std::move(mesh);
    }
    FailedStep(const StepFailure& reason, State<Dim> trial) : StepFailure(reason), trial_(std::move(trial)) {}

    const State<Dim>& trial() const { return trial_; }

private:
    State<Dim> trial_;
};

/// The mesh of `last` with its nodes as they are in `nodes`; those that are not there any more stay as they were.
template <int Dim>
State<Dim> withNodesOf(State<Dim> last, const Nodes<Dim>& nodes);

/// The ids of some nodes, for StepFailure.
template <int Dim, class Indices>
std::vector<Id> idsOf(const Nodes<Dim>& nodes, const Indices& indices) {
    std::vector<Id> ids;
    for (int i : indices) ids.push_back(nodes.id[i]);
    return ids;
}

/// "(x y)" or "(x y z)" with six digits.
template <int Dim>
std::string placeText(const Vec<Dim>& x);

/// Throws StepFailure: "node 17 at (0.1 0.2) " and `what`.
template <int Dim>
[[noreturn]] void failAt(const Nodes<Dim>& nodes, int i, const std::string& what);

/// A trial state that can be written and looked at, with its nodes flagged that the failure concerns: those that it
/// names, nodes whose numbers are not finite, corners of inverted solid elements. What is not finite is zero;
/// positions then are those of `last`. When nothing is found: the fastest node.
template <int Dim>
struct Inspection {
    State<Dim> state;
    std::vector<unsigned char> failed;
    std::string text;  // "node 17 at (0.1 0.2), ..." in words
};

template <int Dim>
Inspection<Dim> inspect(const FailedStep<Dim>& failure, const State<Dim>& last);

}  // namespace pfem
