#include "continuity/compression.hpp"

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
std::vector<double> compressedVolume(const Problem<Dim>& problem, const Cells<Dim>& cells, const NodeToCells& around,
                                     const Nodes<Dim>& now, const std::vector<double>& pOld) {
    std::vector<double> change(now.size(), 0.0);
    parallelFor(now.size(), [&](int i) {
        double compressibility = 0;  // Omega_I/kappa
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const int e = around.cell[s];
            compressibility +=
                simplexMeasure<Dim>(now.x, cells.nodes[e]) / ((Dim + 1) * problem.fluid(cells.material[e]).kappa);
        }
        change[i] = -compressibility * (now.p[i] - pOld[i]);
    });
    return change;
}

template std::vector<double> compressedVolume<2>(const Problem<2>&, const Cells<2>&, const NodeToCells&,
                                                 const Nodes<2>&, const std::vector<double>&);

}  // namespace pfem
