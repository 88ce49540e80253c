#include "material/material.hpp"

#include <algorithm>

#include "material/lawTable.hpp"

namespace pfem {

namespace {

/// The law with this name, null without.
template <class Law>
const LawType<Law>* findLaw(const std::vector<LawType<Law>>& laws, const std::string& name) {
    const auto found = std::find_if(laws.begin(), laws.end(), [&](const auto& law) { return law.name == name; });
    return found == laws.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Material> readMaterials(const Dictionary& dict) {
    std::vector<std::string> types;
    for (const auto& law : fluidLaws()) types.push_back(law.name);
    for (const auto& law : solidLaws()) types.push_back(law.name);
    std::vector<Material> materials;
    for (const auto& key : dict.keys()) {
        if (key == "FoamFile" || !dict.isDict(key)) continue;
        const Dictionary& entry = dict.subDict(key);
        Material m;
        m.name = key;
        const std::string type = entry.choice("type", types);
        if (const auto* law = findLaw(fluidLaws(), type)) {
            m.kind = MaterialKind::fluid;
            m.fluid = readLaw<ViscousFluid>(entry);
            m.fluid.law = law->read(entry);
        } else {
            m.kind = MaterialKind::solid;
            m.solid = readLaw<Solid>(entry);
            m.solid.setLaw(findLaw(solidLaws(), type)->read(entry));
        }
        materials.push_back(std::move(m));
    }
    return materials;
}

const ViscousFluid* firstFluid(const std::vector<Material>& all) {
    for (const auto& m : all)
        if (m.kind == MaterialKind::fluid) return &m.fluid;
    return nullptr;
}

const Material& findMaterial(const std::vector<Material>& all, const std::string& name) {
    std::vector<std::string> names;
    for (const auto& m : all) {
        if (m.name == name) return m;
        names.push_back(m.name);
    }
    throw UserError(notValid(name, "material", names));
}

}  // namespace pfem
