#include "functions/fieldMinMax.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/vectors.hpp"
#include "functions/sampling.hpp"
#include "mesh/topology.hpp"

namespace pfem {

namespace {

/// Is node i part of the region? (flags per node) Of both: of a cell, or a drop; points of walls carry nothing.
template <int Dim>
std::vector<unsigned char> nodesOf(const State<Dim>& state, Region region) {
    const int n = state.nodes.size();
    if (region != Region::both)
        return nodesIn<Dim>((region == Region::solid ? state.mesh.solid : state.mesh.fluid).nodes, n);
    auto member = looseNodes<Dim>(state.mesh, n);
    for (const auto* cells : {&state.mesh.fluid.nodes, &state.mesh.solid.nodes})
        for (const auto& simplex : *cells)
            for (const int i : simplex) member[i] = 1;
    return member;
}

/// A scalar itself, otherwise the Frobenius norm (the off-diagonal components of a tensor count twice).
double magnitude(const std::vector<double>& value) {
    if (value.size() == 1) return value[0];
    double sum = 0;
    for (std::size_t c = 0; c < value.size(); ++c) {
        const bool shear = value.size() == 6 && (c == 1 || c == 2 || c == 4);
        sum += (shear ? 2 : 1) * value[c] * value[c];
    }
    return std::sqrt(sum);
}

}  // namespace

template <int Dim>
FieldMinMax<Dim>::FieldMinMax(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    fields_ = nodalFields<Dim>(dict, dict.get<std::vector<std::string>>("fields"));
}

template <int Dim>
void FieldMinMax<Dim>::start(const State<Dim>&) {
    table_.emplace(context_.folder / "fieldMinMax.dat", context_.precision, context_.resumeAt);
    table_->comment("Field minima and maxima");
    table_->comment("Time\tfield\tmin\tlocation(min)\tmax\tlocation(max)");
}

template <int Dim>
void FieldMinMax<Dim>::execute(const State<Dim>& state) {
    auto location = [&](int i) {
        const auto x = inSpace<Dim>(state.nodes.x[static_cast<std::size_t>(i)]);
        return fmt::format("({} {} {})", table_->number(x[0]), table_->number(x[1]), table_->number(x[2]));
    };
    for (const auto& field : fields_) {
        const auto member = nodesOf(state, field.region);
        int lowest = -1, highest = -1;
        double low = 0, high = 0;
        for (int i = 0; i < state.nodes.size(); ++i) {
            if (member[static_cast<std::size_t>(i)] == 0) continue;
            const double value = magnitude(field.value(state.nodes, i));
            if (lowest < 0 || value < low) low = value, lowest = i;
            if (highest < 0 || value > high) high = value, highest = i;
        }
        if (lowest < 0) continue;
        table_->line(fmt::format("{}\t{}\t{}\t{}\t{}\t{}", table_->time(state.time.value), field.name,
                                 table_->number(low), location(lowest), table_->number(high), location(highest)));
    }
}

#define PFEM_INSTANTIATE(D) template class FieldMinMax<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
