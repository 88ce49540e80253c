#include "solver/newtonDamping.hpp"

#include <algorithm>

namespace pfem {

template <int Dim>
double NewtonDamping<Dim>::next(const Points<Dim>& step) {
    if (last_.size() == step.size()) {
        double both = 0, squares = 0;
        for (std::size_t i = 0; i < step.size(); ++i) {
            both += step[i].dot(last_[i]);
            squares += last_[i].squaredNorm();
        }
        part_ = both < squares ? std::clamp(part_ * squares / (squares - both), 0.1, 1.0) : 1;
    }
    last_ = step;
    return part_;
}

#define PFEM_INSTANTIATE(D) template class NewtonDamping<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
