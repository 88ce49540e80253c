#include "conditions/boundaryConditions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pfem {

namespace {

/// c_f / width of `type sideWalls`.
double readSideFriction(const Dictionary& entry) {
    const auto width = entry.get<double>("width"), friction = entry.get<double>("friction");
    if (!(width > 0)) entry.fatal("width", "Entry 'width' must be positive");
    if (!(friction >= 0)) entry.fatal("friction", "Entry 'friction' must not be negative");
    return friction / width;
}

/// Every patch needs an entry: those without are named all at once.
void demandEntries(const Dictionary& dict, const std::vector<std::string>& names) {
    std::vector<std::string> missing;
    for (const auto& name : names)
        if (!dict.found(name)) missing.push_back("'" + name + "'");
    if (missing.empty()) return;
    throw UserError(
        fmt::format(
            "No entry for {} of the mesh: each wall and each named patch needs one, of its name or of a pattern "
            "such as \"wall.*\"",
            fmt::join(missing, ", ")),
        dict.where());
}

}  // namespace

template <int Dim>
BoundaryConditions<Dim> readBoundaryConditions(const Dictionary& dict, const std::vector<Patch<Dim>>& patches) {
    BoundaryConditions<Dim> result;
    std::vector<std::string> names;
    for (const auto& patch : patches) names.push_back(patch.name);
    for (const auto& key : dict.keys()) {
        if (key == "FoamFile" || !dict.isDict(key) || std::find(names.begin(), names.end(), key) != names.end())
            continue;
        const Dictionary& entry = dict.subDict(key);
        const auto type = entry.found("type") ? entry.get<std::string>("type") : "";
        if (type == "damping")
            result.damping.push_back(readDamping<Dim>(entry));
        else if (Dim == 2 && type == "sideWalls")
            result.sideFriction += readSideFriction(entry);
        else
            dict.fatal(key, notValid(key, "patch", names));
    }
    demandEntries(dict, names);

    for (const auto& patch : patches) {
        const Dictionary& entry = dict.subDict(patch.name);
        const std::string name = entry.choice("type", typeNames());
        const PatchType& type = *std::find_if(patchTypes().begin(), patchTypes().end(),
                                              [&](const PatchType& known) { return known.name == name; });
        result.type.push_back(&type);
        result.kind.push_back(type.kind);
        result.motion.push_back(nullptr);
        if (entry.found("motion")) {
            if (!type.mayMove)
                entry.fatal("motion", "'" + patch.name + "' cannot be moved: only " +
                                          typeList([](const auto& t) { return t.mayMove; }, " and ") + " patches can");
            result.motion.back() = std::make_shared<WallMotion>(entry.subDict("motion"), Dim == 2);
            if (result.motion.back()->absorption() && !isWall(type.kind))
                entry.subDict("motion").fatal("absorb",
                                              "'" + patch.name + "' is no wall: only walls give way to waves");
        }
        if (entry.found("friction") && !type.has("friction"))
            entry.fatal("friction", "'" + patch.name + "' is not of type " +
                                        typeList([](const auto& t) { return t.has("friction"); }, " or ") +
                                        ": only those have 'friction'");
        const PatchEntries entries = type.read ? type.read(entry, Dim == 2) : PatchEntries();
        result.friction.push_back(entries.friction);
        result.inlet.push_back(entries.inlet);
        result.outlet.push_back(entries.outlet);
        result.traction.push_back(Vec<Dim>::Zero());
        result.tractionOverTime.push_back(nullptr);
        if (!entries.traction) continue;
        result.traction.back() = entries.traction->value(0).template head<Dim>();
        if (!entries.traction->isConstant()) result.tractionOverTime.back() = entries.traction;
    }
    return result;
}

template BoundaryConditions<2> readBoundaryConditions<2>(const Dictionary&, const std::vector<Patch<2>>&);
template BoundaryConditions<3> readBoundaryConditions<3>(const Dictionary&, const std::vector<Patch<3>>&);

}  // namespace pfem
