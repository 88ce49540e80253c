#include "linear/minimumDegree.hpp"

#include <cholmod.h>

#include "base/error.hpp"

namespace pfem {

std::vector<int> minimumDegree(const MatrixGraph& graph) {
    const std::size_t n = graph.start.size() - 1;
    std::vector<int> order(n);
    if (n == 0) return order;
    cholmod_sparse A{};
    A.nrow = A.ncol = n;
    A.nzmax = graph.neighbour.size();
    A.p = const_cast<int*>(graph.start.data());
    A.i = const_cast<int*>(graph.neighbour.data());
    A.stype = 1;  // the other triangle says the same
    A.itype = CHOLMOD_INT;
    A.xtype = CHOLMOD_PATTERN;
    A.packed = 1;
    cholmod_common common;
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    const bool done = cholmod_amd(&A, nullptr, 0, order.data(), &common) != 0;
    cholmod_finish(&common);
    if (!done) throw StepFailure("matrix ordering failed (out of memory?)");
    return order;
}

}  // namespace pfem
