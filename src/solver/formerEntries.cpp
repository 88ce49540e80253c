#include "solver/formerEntries.hpp"

#include <fmt/format.h>

#include "material/hypoelastic.hpp"
#include "material/neoHookean.hpp"

namespace pfem {

namespace {

template <class Law>
std::shared_ptr<const SolidLaw> withElasticity(const IsotropicElasticity& elastic) {
    auto law = std::make_shared<Law>();
    law->elastic = elastic;
    return law;
}

}  // namespace

template <int Dim>
std::string applyStressUpdate(const Dictionary& pfemSolution, Problem<Dim>& problem) {
    const Dictionary& solid = pfemSolution.subDictOrEmpty("solid");
    const auto update = solid.get<std::string>("stressUpdate", "rotatedMidpoint");
    const bool neoHookean = update == "neoHookean";
    if (!neoHookean && update != "paper") return "";
    std::string names;
    for (auto& material : problem.materials) {
        if (material.kind != MaterialKind::solid) continue;
        if (dynamic_cast<const Hypoelastic*>(material.solid.law.get()) == nullptr) continue;
        const IsotropicElasticity elastic = material.solid.elastic;
        material.solid.setLaw(neoHookean ? withElasticity<NeoHookean>(elastic)
                                         : withElasticity<HypoelasticPaper>(elastic));
        names += (names.empty() ? "" : ", ") + material.name;
    }
    const Location at = solid.where("stressUpdate");
    if (names.empty())
        return fmt::format("entry 'stressUpdate' in {}:{} has no effect: the laws stand in constant/materials", at.file,
                           at.line);
    return fmt::format(
        "entry 'stressUpdate' in {}:{}: the law now stands in constant/materials. Write 'type {};' there, for {}, and "
        "leave 'stressUpdate' out",
        at.file, at.line, neoHookean ? "neoHookean" : "hypoelasticPaper", names);
}

std::string takeFormerRemeshing(const Dictionary& pfemSolution, ExpertRemeshing& expert) {
    const Dictionary& dict = pfemSolution.subDictOrEmpty("remeshing");
    std::string names;
    for (const auto& row : describeEntries<ExpertRemeshing>())
        if (dict.found(row.name)) names += (names.empty() ? "" : " ") + row.name;
    if (names.empty()) return "";
    readEntries(dict, expert);
    const Location at = dict.where();
    return fmt::format("{}:{}: write these entries of 'remeshing' into its sub-dictionary 'expert': {}", at.file,
                       at.line, names);
}

#define PFEM_INSTANTIATE(D) template std::string applyStressUpdate<D>(const Dictionary&, Problem<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
