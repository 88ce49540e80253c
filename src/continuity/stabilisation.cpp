#include "continuity/stabilisation.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace pfem {

namespace {

template <int Dim>
double cellSize(double measure) {
    return Dim == 2 ? std::sqrt(2 * measure) : std::cbrt(6 * measure);
}

}  // namespace

template <int Dim>
std::vector<double> stabilisation(const Problem<Dim>& problem, const Cells<Dim>& cells,
                                  const Patches<Dim>& patches, const std::vector<double>& mu, const Points<Dim>& v,
                                  double dt) {
    std::vector<double> tau(cells.size());
#pragma omp parallel for schedule(static) if (cells.size() > shortLoop)
    for (int e = 0; e < cells.size(); ++e) {
        const ViscousFluid& fluid = problem.fluid(cells.material[e]);
        const double h = cellSize<Dim>(patches.element[e].measure);
        Vec<Dim> mean = Vec<Dim>::Zero();
        for (int node : cells.nodes[e]) mean += v[node] / (Dim + 1);
        tau[e] = 1 / (8 * mu[e] / (h * h) + fluid.rho / dt + fluid.rho * mean.norm() / h);
    }
    return tau;
}

template <int Dim>
double surfaceStabilisation(double tau, double mu, double cellMeasure, double faceMeasure) {
    const double h = cellSize<Dim>(std::abs(cellMeasure)), height = Dim * cellMeasure / faceMeasure;
    return 1 / (1 / tau + mu * std::max(0.0, 4 * (Dim + 1) / (height * height) - 8 / (h * h)));
}

template double surfaceStabilisation<2>(double, double, double, double);
template std::vector<double> stabilisation<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&,
                                              const std::vector<double>&, const Points<2>&, double);

}  // namespace pfem
