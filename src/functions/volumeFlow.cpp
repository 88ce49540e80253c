#include "functions/volumeFlow.hpp"

#include "functions/surfaces.hpp"

namespace pfem {

template <int Dim>
double volumeFlow(const State<Dim>& state, const Plane<Dim>& plane) {
    const auto& nodes = state.nodes;
    std::vector<double> across;
    for (const auto& v : nodes.v) across.push_back(v.dot(plane.normal));
    double rate = 0;
    for (const auto& piece : cutByPlane<Dim>(nodes.x, state.mesh.fluid.nodes, plane))
        rate += integralOver<Dim>(piece, nodes.x, across);
    return rate;
}

template <int Dim>
VolumeFlow<Dim>::VolumeFlow(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    const auto entries = readEntries<VolumeFlowEntries>(dict);
    plane_ = planeOf<Dim>(dict, "normal", entries.point, entries.normal);
}

template <int Dim>
void VolumeFlow<Dim>::start(const State<Dim>& state) {
    volume_ = 0;
    if (const auto found = state.memory.find(context_.name); found != state.memory.end() && !found->second.empty())
        volume_ = found->second[0];
    time_ = state.time.value;
    rate_ = volumeFlow<Dim>(state, plane_);
    table_.emplace(context_.folder / "volumeFlow.dat", context_.precision, context_.resumeAt);
    table_->comment("Fluid that passes the plane: rate [m2/s (2D), m3/s] and volume since the beginning [m2 (2D), m3]");
    table_->header({"Time", "rate", "volume"});
}

template <int Dim>
void VolumeFlow<Dim>::advance(const State<Dim>& state) {
    const double dt = state.time.value - time_;
    if (!(dt > 0)) return;
    const double rate = volumeFlow<Dim>(state, plane_);
    volume_ += 0.5 * dt * (rate_ + rate);
    rate_ = rate;
    time_ = state.time.value;
}

template <int Dim>
void VolumeFlow<Dim>::execute(const State<Dim>& state) {
    table_->row({table_->time(state.time.value), table_->number(rate_), table_->number(volume_)});
}

#define PFEM_INSTANTIATE(D)                                          \
    template double volumeFlow<D>(const State<D>&, const Plane<D>&); \
    template class VolumeFlow<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
