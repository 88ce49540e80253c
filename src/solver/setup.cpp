#include "solver/setup.hpp"

#include <algorithm>
#include <iostream>

namespace pfem {

namespace {

template <int Dim>
Vec<Dim> readGravity(const Dictionary& dict) {
    const auto dimensions = dict.get<std::vector<double>>("dimensions", {0, 1, -2, 0, 0, 0, 0});
    const std::vector<double> acceleration = {0, 1, -2, 0, 0, 0, 0};
    for (std::size_t k = 0; k < dimensions.size(); ++k)
        if (dimensions[k] != acceleration[std::min<std::size_t>(k, 6)])
            dict.fatal("dimensions", "gravity is an acceleration: dimensions [0 1 -2 0 0 0 0]");
    return dict.get<Eigen::Vector3d>("value").head<Dim>();
}

template <class Options>
void readPart(const Dictionary& dict, const std::string& name, Options& options) {
    readEntries(dict.subDictOrEmpty(name), options);
}

}  // namespace

template <int Dim>
Problem<Dim> readProblem(const Case& theCase, const Mesh<Dim>& mesh) {
    Problem<Dim> problem;
    const Dictionary materials = Dictionary::read(theCase.constant("materials"));
    const auto all = readMaterials(materials);
    for (const auto& name : mesh.materials) {
        try {
            problem.materials.push_back(findMaterial(all, name));
        } catch (const UserError& error) {
            throw UserError(error.what() + std::string("\n\nThe mesh in the time folder asks for it; was it made from other dictionaries?"),
                            materials.where());
        }
    }
    const auto check = [&](const Cells<Dim>& cells, MaterialKind kind, const char* word) {
        for (int m : cells.material)
            if (problem.materials[m].kind != kind)
                throw UserError("material '" + problem.materials[m].name + "' is not a " + word, materials.where());
    };
    check(mesh.fluid, MaterialKind::fluid, "fluid");
    check(mesh.solid, MaterialKind::solid, "solid");

    const Dictionary g = Dictionary::read(theCase.constant("g"));
    problem.gravity = readGravity<Dim>(g);
    const Dictionary conditions = Dictionary::read(theCase.constant("boundaryConditions"));
    problem.conditions = readBoundaryConditions<Dim>(conditions, mesh.patches);
    for (const auto* dict : {&materials, &g, &conditions}) warnUnused(*dict, std::cerr);
    return problem;
}

Controls readControls(const Case& theCase) {
    Controls controls;
    if (!std::filesystem::exists(theCase.system("pfemSolution"))) return controls;
    const Dictionary dict = Dictionary::read(theCase.system("pfemSolution"));
    readEntries(dict, controls.integration);
    readPart(dict, "timeIntegration", controls.timeIntegration);
    readPart(dict, "convergence", controls.convergence);
    readPart(dict, "momentum", controls.momentum);
    readPart(dict, "continuity", controls.continuity);
    readPart(dict, "solid", controls.solid);
    readPart(dict, "remeshing", controls.remeshing);
    warnUnused(dict, std::cerr);
    return controls;
}

template Problem<2> readProblem<2>(const Case&, const Mesh<2>&);

}  // namespace pfem
