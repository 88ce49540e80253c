#include "functions/boundingBox.hpp"

#include <algorithm>

#include "base/vectors.hpp"
#include "functions/sensors.hpp"

namespace pfem {

namespace {

/// Lower and upper corner, padded to three components; dry when no node has come in.
template <int Dim>
class Box {
public:
    void add(const Vec<Dim>& x) {
        for (int c = 0; c < Dim; ++c) {
            low_[c] = empty_ ? x[c] : std::min(low_[c], x[c]);
            high_[c] = empty_ ? x[c] : std::max(high_[c], x[c]);
        }
        empty_ = false;
    }
    std::vector<double> low() const { return corner(low_); }
    std::vector<double> high() const { return corner(high_); }

private:
    std::vector<double> corner(const Vec<Dim>& x) const {
        if (empty_) return {dry, dry, dry};
        return threeNumbers<Dim>(x);
    }
    bool empty_ = true;
    Vec<Dim> low_ = Vec<Dim>::Zero(), high_ = Vec<Dim>::Zero();
};

}  // namespace

template <int Dim>
void BoundingBox<Dim>::start(const State<Dim>&) {
    table_.emplace(context_.folder / "boundingBox.dat", context_.precision, context_.resumeAt);
    table_->header({"Time", "fluidMin", "fluidMax", "solidMin", "solidMax"});
}

template <int Dim>
void BoundingBox<Dim>::execute(const State<Dim>& state) {
    Box<Dim> fluid, solid;
    const auto& nodes = state.nodes;
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int i : cell) fluid.add(nodes.x[i]);
    for (int i = 0; i < nodes.size(); ++i)
        if (nodes.dropVolume[i] > 0) fluid.add(nodes.x[i]);
    for (const auto& cell : state.mesh.solid.nodes)
        for (const int i : cell) solid.add(nodes.x[i]);
    table_->row({table_->time(state.time.value), table_->tuple(fluid.low()), table_->tuple(fluid.high()),
                 table_->tuple(solid.low()), table_->tuple(solid.high())});
}

#define PFEM_INSTANTIATE(D) template class BoundingBox<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
