#pragma once
// Preconditioned conjugate gradients for a symmetric positive definite operator that need not be a matrix.

#include <functional>
#include <string>

#include "base/types.hpp"

namespace pfem {

/// Vectors of nodes to vectors of nodes, linear.
template <int Dim>
using NodalOperator = std::function<Points<Dim>(const Points<Dim>&)>;

struct GradientControls {
    double tolerance = 1e-8;  // of the residual in the preconditioner's norm sqrt(r . z), beside that of b
    int maxIterations = 1000;
    std::string name;  // of the system, for messages
};

template <int Dim>
struct GradientSolution {
    Points<Dim> x;
    int iterations = 0;
};

/// x of A x = b from x = 0 (Hestenes and Stiefel): `apply` is A, `precondition` an approximate inverse, both symmetric
/// positive definite where b has parts. Throws StepFailure when A is not, or when the tolerance is not met.
template <int Dim>
GradientSolution<Dim> conjugateGradients(const NodalOperator<Dim>& apply, const NodalOperator<Dim>& precondition,
                                         Points<Dim> b, const GradientControls& controls);

}  // namespace pfem
