#pragma once
// Direct solution by parts that meet in few unknowns, each with its own processor.

#include <vector>

#include "linear/multifrontal.hpp"
#include "linear/symmetricSolver.hpp"

namespace pfem {

/// A x = b, where the unknowns that couple two parts form a small system of their own (Schur complement). The parts
/// are factored and solved at the same time; the bits do not depend on the number of threads. The factor of the parts
/// is computed as `Real` and kept as `Stored`, float or double.
template <int Dim, class Stored, class Real = double>
class DissectedLdlt : public SymmetricSolver {
public:
    /// `where` each unknown is, which gives the order of elimination; `part`: a number 0 ... nParts-1 for each.
    DissectedLdlt(Places<Dim> where, std::vector<int> part, int nParts);

    void analyse(const SymmetricMatrix& A) override;
    void factor(const SymmetricMatrix& A) override;
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;

private:
    struct Part {
        std::vector<int> interior;  // unknowns of A, in the order of the factor
        std::vector<Piece> pieces;  // that are eliminated together
        std::vector<int> shared;    // indices into shared_ of the unknowns that follow them
        Multifrontal<Stored, Real> factor;
    };

    void factorBetween(const SymmetricMatrix& A);

    Places<Dim> where_;
    std::vector<int> part_;
    std::vector<Part> parts_;
    std::vector<int> shared_;       // unknowns of A between the parts
    std::vector<int> placeShared_;  // per unknown: -2 - its index in shared_, or -1
    Eigen::MatrixXd between_;       // D and L of the Schur complement
};

/// Part of each place when all are cut into nParts of about equal number, perpendicular to the axis; `nShared` is how
/// many each part but the last is to have beyond that.
template <int Dim>
std::vector<int> slabs(const Places<Dim>& place, int nParts, int axis, int nShared = 0);

/// Unknowns that lie between the parts: of each entry across, the one in the lower part.
std::vector<unsigned char> sharedUnknowns(const SymmetricMatrix& A, const std::vector<int>& part);

}  // namespace pfem
