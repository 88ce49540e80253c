#include "continuity/compression.hpp"

#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
std::vector<double> compressedVolume(const Problem<Dim>& problem, const Cells<Dim>& cells, const NodeToCells& around,
                                     const Nodes<Dim>& now, const std::vector<double>& pOld, const Ranks& ranks) {
    return ranks.each(now.size(), [&](int i) {
        double compressibility = 0;  // Omega_I/kappa
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const int e = around.cell[s];
            compressibility +=
                simplexMeasure<Dim>(now.x, cells.nodes[e]) / ((Dim + 1) * problem.fluid(cells.material[e]).kappa);
        }
        return -compressibility * (now.p[i] - pOld[i]);
    });
}

#define PFEM_INSTANTIATE(D)                                                                                  \
    template std::vector<double> compressedVolume<D>(const Problem<D>&, const Cells<D>&, const NodeToCells&, \
                                                     const Nodes<D>&, const std::vector<double>&, const Ranks&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
