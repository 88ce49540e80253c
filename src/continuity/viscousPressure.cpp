#include "continuity/viscousPressure.hpp"

namespace pfem {

template <int Dim>
void addViscousPressure(const SmoothingDomains<Dim>& fluid, const PerCell<double>& mu, const PerNode<double>& scale,
                        const PerNode<double>& residual, PerNode<double>& dp) {
    const NodeToCells& around = *fluid.around;
    fluid.share.forNodes(fluid.nNodes(), [&](int i) {
        double sum = 0;  // (d+1) Omega_I mu_I
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            sum += fluid.element[around.cell[s]].measure * mu[around.cell[s]];
        const double volume = fluid.volume[i];
        if (volume > 0) dp[i] -= scale[i] * sum / ((Dim + 1) * volume) * residual[i] / volume;
    });
    fluid.share.gather(dp);
}

#define PFEM_INSTANTIATE(D)                                                                 \
    template void addViscousPressure<D>(const SmoothingDomains<D>&, const PerCell<double>&, \
                                        const std::vector<double>&, const std::vector<double>&, std::vector<double>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
