#include "functions/massBalance.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "dictionary/dictionary.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

std::map<std::string, double> readDensities(const std::filesystem::path& caseRoot) {
    const Dictionary materials = Dictionary::read(caseRoot / "constant" / "materials");
    std::map<std::string, double> densities;
    for (const auto& name : materials.keys())
        if (materials.isDict(name) && materials.subDict(name).found("rho"))
            densities[name] = materials.subDict(name).dimensioned("rho", {1, -3, 0, 0, 0, 0, 0});
    return densities;
}

template <int Dim>
double fluidMass(const State<Dim>& state, const std::map<std::string, double>& densities) {
    const auto& cells = state.mesh.fluid;
    std::vector<double> volumes(state.mesh.materials.size(), 0.0);
    for (std::size_t e = 0; e < cells.nodes.size(); ++e)
        volumes.at(static_cast<std::size_t>(cells.material[e])) += simplexMeasure<Dim>(state.nodes.x, cells.nodes[e]);
    if (!volumes.empty() && !cells.material.empty())
        volumes[static_cast<std::size_t>(*std::min_element(cells.material.begin(), cells.material.end()))] +=
            dropVolume<Dim>(state) - state.ledger[VolumeCause::compression];
    double mass = 0;
    for (std::size_t m = 0; m < volumes.size(); ++m) {
        if (volumes[m] == 0) continue;
        const auto rho = densities.find(state.mesh.materials[m]);
        if (rho == densities.end())
            throw UserError("material '" + state.mesh.materials[m] + "' has no entry 'rho' in constant/materials");
        mass += rho->second * volumes[m];
    }
    return mass;
}

template <int Dim>
MassAccount<Dim>::MassAccount(const State<Dim>& initial, std::map<std::string, double> densities)
    : densities_(std::move(densities)),
      initialLedger_(initial.ledger.byName()),
      initialVolume_(totalVolume<Dim>(initial)),
      initialMass_(fluidMass(initial, densities_)) {}

template <int Dim>
MassBalance MassAccount<Dim>::balance(const State<Dim>& state) const {
    MassBalance b;
    b.time = state.time.value;
    b.volume = totalVolume<Dim>(state);
    b.mass = fluidMass(state, densities_);
    b.relativeChange = initialMass_ > 0 ? (b.mass - initialMass_) / initialMass_ : 0.0;
    b.causes = state.ledger.byName();
    for (const auto& [cause, volume] : initialLedger_) b.causes[cause] -= volume;
    for (const auto& [cause, volume] : b.causes) b.sumOfCauses += volume;
    VolumeLedger ledger;
    ledger.takeFrom(b.causes);
    const double passage = ledger.sum(CauseKind::passage);
    b.withoutPassage = b.relativeChange - (initialVolume_ > 0 ? passage / initialVolume_ : 0);
    b.unexplained = b.volume - initialVolume_ - b.sumOfCauses;
    return b;
}

#define PFEM_INSTANTIATE(D)                                                              \
    template double fluidMass<D>(const State<D>&, const std::map<std::string, double>&); \
    template class MassAccount<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
