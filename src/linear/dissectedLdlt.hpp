#pragma once
// Direct solution by parts that meet in few unknowns, each with its own processor.

#include <vector>

#include "linear/multifrontal.hpp"
#include "linear/symmetricMatrix.hpp"

namespace pfem {

/// A x = b, where the unknowns that couple two parts form a small system of their own (Schur complement). The parts
/// are factored and solved at the same time; the bits do not depend on the number of threads. The factor is kept as
/// `Stored`, float or double.
template <class Stored>
class DissectedLdlt {
public:
    /// `where` each unknown is, which gives the order of elimination; `part`: a number 0 ... nParts-1 for each. Throws
    /// StepFailure when a pivot vanishes or is not finite.
    template <int Dim>
    void factorize(const SymmetricMatrix& A, const Places<Dim>& where, const std::vector<int>& part, int nParts);

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

private:
    struct Part {
        std::vector<int> interior;  // unknowns of A, in the order of the factor
        std::vector<int> shared;    // indices into shared_ of the unknowns that follow them
        Multifrontal<Stored> factor;
    };

    std::vector<int> shared_;  // unknowns of A between the parts
    std::vector<Part> parts_;
    Eigen::MatrixXd between_;  // D and L of the Schur complement
};

/// Part of each place when all are cut into nParts of about equal number, perpendicular to the axis.
template <int Dim>
std::vector<int> slabs(const Places<Dim>& place, int nParts, int axis);

}  // namespace pfem
