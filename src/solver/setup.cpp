#include "solver/setup.hpp"

#include <algorithm>
#include <iostream>

#include "conditions/periodic.hpp"
#include "dictionary/dimensions.hpp"
#include "solver/checkMotions.hpp"
#include "solver/checkOpenings.hpp"
#include "solver/checkPeriodic.hpp"
#include "solver/checkProblem.hpp"
#include "solver/formerEntries.hpp"

namespace pfem {

namespace {

template <int Dim>
Function1Ptr<Eigen::Vector3d> readGravity(const Dictionary& dict) {
    if (dict.found("dimensions")) {
        TokenReader reader = dict.reader("dimensions");
        if (!sameDimensions(readDimensions(reader), {0, 1, -2, 0, 0, 0, 0}))
            dict.fatal("dimensions", "gravity is an acceleration: dimensions [0 1 -2 0 0 0 0]");
        reader.end();
    }
    return Dim == 2 ? readPlaneFunction1(dict, "value") : readFunction1<Eigen::Vector3d>(dict, "value");
}

template <class Options>
void readPart(const Dictionary& dict, const std::string& name, Options& options) {
    readEntries(dict.subDictOrEmpty(name), options);
}

}  // namespace

template <int Dim>
Problem<Dim> readProblem(const Case& theCase, const State<Dim>& state, std::ostream* warnings) {
    const Mesh<Dim>& mesh = state.mesh;
    Problem<Dim> problem;
    const Dictionary materials = Dictionary::read(theCase.constant("materials"));
    const auto all = readMaterials(materials);
    for (const auto& name : mesh.materials) {
        try {
            problem.materials.push_back(findMaterial(all, name));
        } catch (const UserError& error) {
            const std::string near = nearestWord(name, materials.keys());
            throw UserError(
                error.what() +
                    std::string("\n\nThe mesh in the time folder asks for it; was it made from other dictionaries?"),
                near.empty() ? materials.where() : materials.where(near));
        }
    }
    const auto check = [&](const Cells<Dim>& cells, MaterialKind kind, const char* word) {
        for (int m : cells.material)
            if (problem.materials[m].kind != kind)
                throw UserError("material '" + problem.materials[m].name + "' is not a " + word, materials.where());
    };
    check(mesh.fluid, MaterialKind::fluid, "fluid");
    check(mesh.solid, MaterialKind::solid, "solid");
    checkOneFluid<Dim>(materials, mesh);
    const std::string moved = applyStressUpdate<Dim>(pfemSolution(theCase), problem);
    if (warnings && !moved.empty()) *warnings << "--> PFEM Warning: " << moved << "\n";

    const Dictionary g = Dictionary::read(theCase.constant("g"));
    problem.gravityOverTime = readGravity<Dim>(g);
    if (g.found("frameVelocity"))
        problem.frameOverTime =
            Dim == 2 ? readPlaneFunction1(g, "frameVelocity") : readFunction1<Eigen::Vector3d>(g, "frameVelocity");
    problem = problemAt<Dim>(state.time.value, problem);
    const Dictionary conditions = Dictionary::read(theCase.constant("boundaryConditions"));
    problem.conditions = readBoundaryConditions<Dim>(conditions, mesh.patches);
    checkConditions<Dim>(conditions, problem.conditions, state);
    checkRigidMotions<Dim>(conditions, problem, state);
    checkOpenings<Dim>(conditions, problem, state);
    const auto contactFile = theCase.constant("contact");
    const Dictionary contact = std::filesystem::exists(contactFile) ? Dictionary::read(contactFile) : Dictionary();
    problem.contact.on = std::filesystem::exists(contactFile);
    readEntries(contact, problem.contact);
    const auto periodicFile = theCase.constant("periodic");
    const Dictionary periodic = std::filesystem::exists(periodicFile) ? Dictionary::read(periodicFile) : Dictionary();
    problem.period = periodOf<Dim>(periodic, readEntries<PeriodicEntries>(periodic));
    problem.flow = heldFlowOf<Dim>(periodic, problem.period);
    checkPeriodic<Dim>(periodic, problem, state);
    for (const auto* dict : {&materials, &g, &conditions, &contact, &periodic})
        if (warnings) warnUnused(*dict, *warnings);
    if (warnings && state.time.index == 0)
        for (const auto& text : doubts<Dim>(materials, g, conditions, problem, state))
            *warnings << "--> PFEM Warning: " << text << "\n";
    return problem;
}

Dictionary pfemSolution(const Case& theCase) {
    const auto file = theCase.system("pfemSolution");
    return std::filesystem::exists(file) ? Dictionary::read(file) : Dictionary();
}

Controls readControls(const Case& theCase, std::ostream* warnings) {
    Controls controls;
    const Dictionary dict = pfemSolution(theCase);
    readEntries(dict, controls.integration);
    readPart(dict, "timeIntegration", controls.timeIntegration);
    readPart(dict, "convergence", controls.convergence);
    if (controls.convergence.minIterations > controls.convergence.maxIterations)
        dict.fatal("convergence", "minIterations is larger than maxIterations: no step could be accepted");
    readPart(dict, "momentum", controls.momentum);
    readPart(dict, "continuity", controls.continuity);
    readPart(dict, "solid", controls.solid);
    readPart(dict, "remeshing", controls.remeshing);
    readPart(dict.subDictOrEmpty("remeshing"), "expert", controls.remeshing.expert);
    const std::string moved = takeFormerRemeshing(dict, controls.remeshing.expert);
    if (warnings && !moved.empty()) *warnings << "--> PFEM Warning: " << moved << "\n";
    const auto& r = controls.remeshing;
    if (r.insertDistance < 2 * std::max({r.removeDistance, r.removeDistanceSurface, r.expert.removeDistanceFilm}))
        dict.subDictOrEmpty("remeshing")
            .fatal(
                "insertDistance",
                "insertDistance must be at least twice removeDistance, removeDistanceSurface and removeDistanceFilm: "
                "the halves of a divided edge would be removed again");
    if (warnings) warnUnused(dict, *warnings);
    return controls;
}

#define PFEM_INSTANTIATE(D) template Problem<D> readProblem<D>(const Case&, const State<D>&, std::ostream*);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
