#include "solver/flowDrive.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include "base/parallel.hpp"

namespace pfem {

template <int Dim>
FlowDrive<Dim>::FlowDrive(const Step<Dim>& step, const FluidPhase<Dim>& fluid) : step_(step), fluid_(fluid) {
    if (!step.problem.flow) return;
    for (int k = 0; k < Dim; ++k)
        if (step.problem.period.length[k] > 0) directions_.push_back(k);
}

template <int Dim>
Vec<Dim> FlowDrive<Dim>::integral(const std::vector<double>& volumes, const Points<Dim>& u) const {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int i = 0; i < fluid_.domains.nNodes(); ++i)
        if (!step_.isImage(i)) sum += volumes[i] * u[i];
    return sum;
}

template <int Dim>
void FlowDrive<Dim>::hold(MomentumEquation<Dim>& momentum, Trial<Dim>& trial, Points<Dim>& dv) {
    if (directions_.empty()) return;
    if (answers_.empty())
        for (const int k : directions_) answers_.push_back(momentum.answer(Vec<Dim>::Unit(k)));
    auto volumes = fluid_.domains.volume;
    fluid_.domains.share.gather(volumes);
    double volume = 0;
    for (int i = 0; i < fluid_.domains.nNodes(); ++i)
        if (!step_.isImage(i)) volume += volumes[i];
    if (volume == 0) return;
    const double end = step_.problem.time + (1 - step_.gamma()) * step_.dt();
    const Vec<Dim> missing = step_.problem.flow->template integral<Dim>(step_.problem.period, volume, end) -
                             integral(volumes, trial.end.v) - integral(volumes, dv);
    const int n = static_cast<int>(directions_.size());
    Eigen::MatrixXd gain(n, n);
    Eigen::VectorXd wanted(n);
    for (int a = 0; a < n; ++a) {
        const Vec<Dim> ofAnswer = integral(volumes, answers_[a]);
        for (int b = 0; b < n; ++b) gain(b, a) = ofAnswer[directions_[b]];
        wanted[a] = missing[directions_[a]];
    }
    const Eigen::VectorXd change = gain.lu().solve(wanted);
    if (!change.allFinite())
        throw StepFailure(fmt::format("no body force holds the flow through the periodic sides: int v dV lacks {:.4g}",
                                      missing.norm()));
    for (int a = 0; a < n; ++a) {
        trial.drive[directions_[a]] += change[a];
        parallelFor(static_cast<int>(dv.size()), [&](int i) { dv[i] += change[a] * answers_[a][i]; });
    }
}

#define PFEM_INSTANTIATE(D) template class FlowDrive<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
