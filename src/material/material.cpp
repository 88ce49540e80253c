#include "material/material.hpp"

#include <algorithm>

#include "dictionary/entries.hpp"

namespace pfem {

namespace {

constexpr std::array<double, 7> density = {1, -3, 0, 0, 0, 0, 0};
constexpr std::array<double, 7> viscosity = {1, -1, -1, 0, 0, 0, 0};
constexpr std::array<double, 7> pressure = {1, -1, -2, 0, 0, 0, 0};
constexpr std::array<double, 7> none = {0, 0, 0, 0, 0, 0, 0};

double positiveNumber(const Dictionary& dict, const std::string& key, const std::array<double, 7>& dimensions) {
    const double value = dict.dimensioned(key, dimensions);
    if (!(value > 0)) dict.fatal(key, "Entry '" + key + "' must be positive");
    return value;
}

double nonNegativeNumber(const Dictionary& dict, const std::string& key, const std::array<double, 7>& dimensions) {
    const double value = dict.dimensioned(key, dimensions);
    if (value < 0) dict.fatal(key, "Entry '" + key + "' must not be negative");
    return value;
}

ViscousFluid readFluid(const Dictionary& dict, const std::string& type) {
    ViscousFluid m;
    m.rho = positiveNumber(dict, "rho", density);
    if (type == "herschelBulkley") {
        m.exponent = positiveNumber(dict, "n", none);
        m.mu = positiveNumber(dict, "k", {1, -1, m.exponent - 2, 0, 0, 0, 0});
    } else {
        m.mu = nonNegativeNumber(dict, "mu", viscosity);
    }
    if (type != "newtonian") {
        m.yieldStress = nonNegativeNumber(dict, "tau0", pressure);
        if (dict.found("m")) m.regularisation = positiveNumber(dict, "m", {0, 0, 1, 0, 0, 0, 0});
    }
    m.kappa = dict.found("kappa") ? positiveNumber(dict, "kappa", pressure) : m.kappa;
    return m;
}

Hypoelastic readHypoelastic(const Dictionary& dict) {
    Hypoelastic m;
    m.rho = positiveNumber(dict, "rho", density);
    m.E = positiveNumber(dict, "E", pressure);
    m.nu = dict.dimensioned("nu", none);
    if (!(m.nu > -1 && m.nu < 0.5))
        dict.fatal("nu", "Entry 'nu' must be above -1 and below 0.5 (a compressible solid)");
    return m;
}

}  // namespace

std::vector<Material> readMaterials(const Dictionary& dict) {
    std::vector<Material> materials;
    for (const auto& key : dict.keys()) {
        if (key == "FoamFile" || !dict.isDict(key)) continue;
        const Dictionary& entry = dict.subDict(key);
        Material m;
        m.name = key;
        const std::vector<std::string> fluids = {"newtonian", "bingham", "herschelBulkley"};
        std::vector<std::string> types = fluids;
        types.push_back("hypoelastic");
        for (const auto& added : addedSolidLaws()) types.push_back(added);
        const std::string type = entry.choice("type", types);
        if (std::find(fluids.begin(), fluids.end(), type) != fluids.end()) {
            m.kind = MaterialKind::fluid;
            m.fluid = readFluid(entry, type);
        } else {
            m.kind = MaterialKind::solid;
            m.solid = readHypoelastic(entry);
            if (type != "hypoelastic") m.solid.law = makeSolidLaw(type, entry, m.solid);
        }
        materials.push_back(m);
    }
    return materials;
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
