#include "linear/conjugateGradients.hpp"

#include "base/error.hpp"

namespace pfem {

namespace {

template <int Dim>
double dot(const Points<Dim>& a, const Points<Dim>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
}

template <int Dim>
void axpy(double factor, const Points<Dim>& x, Points<Dim>& y) {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] += factor * x[i];
}

}  // namespace

template <int Dim>
GradientSolution<Dim> conjugateGradients(const NodalOperator<Dim>& apply, const NodalOperator<Dim>& precondition,
                                         Points<Dim> b, const GradientControls& controls) {
    Points<Dim> r = std::move(b);
    Points<Dim> z = precondition(r);
    Points<Dim> direction = z;
    GradientSolution<Dim> solution{Points<Dim>(r.size(), Vec<Dim>::Zero()), 0};
    double rz = dot<Dim>(r, z);
    const double target = controls.tolerance * controls.tolerance * rz;
    for (; rz > target && solution.iterations < controls.maxIterations; ++solution.iterations) {
        const Points<Dim> q = apply(direction);
        const double curvature = dot<Dim>(direction, q);
        if (!(curvature > 0)) throw StepFailure(controls.name + " matrix is not positive definite");
        const double step = rz / curvature;
        axpy<Dim>(step, direction, solution.x);
        axpy<Dim>(-step, q, r);
        z = precondition(r);
        const double rzNew = dot<Dim>(r, z);
        const double beta = rzNew / rz;
        for (std::size_t i = 0; i < z.size(); ++i) direction[i] = z[i] + beta * direction[i];
        rz = rzNew;
    }
    if (!(rz <= target)) throw StepFailure("conjugate gradients of the " + controls.name + " did not converge");
    return solution;
}

#define PFEM_INSTANTIATE(D)                                                                                         \
    template GradientSolution<D> conjugateGradients<D>(const NodalOperator<D>&, const NodalOperator<D>&, Points<D>, \
                                                       const GradientControls&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
