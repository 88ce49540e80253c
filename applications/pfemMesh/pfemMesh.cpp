// system/meshDict + constant/materials -> 0/: mesh the bodies and walls, write the state at time 0. From
// constant/boundaryConditions, where there is one: through which walls the first velocity goes.

#include <sys/resource.h>

#include <fmt/format.h>

#include <chrono>
#include <iostream>

#include "application/runApplication.hpp"
#include "case/runLock.hpp"
#include "case/timeFolders.hpp"
#include "conditions/boundaryConditions.hpp"
#include "io/series.hpp"
#include "io/stateFiles.hpp"
#include "mesher/meshFile.hpp"
#include "mesher/meshReport.hpp"
#include "mesher/openings.hpp"
#include "mesher/readMeshDict.hpp"
#include "mesher/space/readSpaceDict.hpp"
#include "mesher/space/spaceReport.hpp"
#include "solver/checkProblem.hpp"
#include "solver/sharedPlaces.hpp"

using namespace pfem;

namespace {

std::vector<std::string> materialNames(const Case& theCase) {
    const Dictionary materials = Dictionary::read(theCase.constant("materials"));
    std::vector<std::string> names;
    for (const auto& key : materials.keys())
        if (materials.isDict(key)) names.push_back(key);
    return names;
}

double meshSizeOption(const Options& options) {
    if (!options.found("h")) return 0;
    const auto h = asNumber(options.get("h"));
    if (!h || !(*h > 0)) throw UserError("-h " + options.get("h") + ": the mesh size must be a positive number");
    return *h;
}

/// A run would go on from a later time, which knows nothing of the new mesh.
void warnOfLaterTimes(const Case& theCase) {
    const auto times = listTimes(theCase.root()).complete;
    if (times.back().value > 0)
        std::cerr << "--> PFEM Warning: the case has results of an older mesh, up to time " << times.back().name
                  << ": remove these folders (./Allclean), or the solver goes on from the latest\n";
}

/// What the solver would say of the patches' conditions, as soon as there are patches. The mesh itself is sound.
template <int Dim>
void checkConditions(const Case& theCase, const State<Dim>& state) {
    const auto file = theCase.constant("boundaryConditions");
    if (!std::filesystem::exists(file)) return;
    try {
        const Dictionary dict = Dictionary::read(file);
        const auto conditions = readBoundaryConditions<Dim>(dict, state.mesh.patches);
        pfem::checkConditions<Dim>(dict, conditions, state);
        std::cout << sharedPlacesText<Dim>(conditions, std::filesystem::exists(theCase.constant("contact")), state);
        warnUnused(dict, std::cerr);
    } catch (const UserError& error) {
        std::cerr << "--> PFEM Warning: pfemFsiFoam will refuse the conditions in " << toString(error.where()) << ": "
                  << error.what() << "\n";
    }
}

/// Walls that are openings let the first velocity through. What is wrong with the conditions is told in the end.
template <class Description>
void markOpenings(const Case& theCase, Description& description) {
    const auto file = theCase.constant("boundaryConditions");
    if (!std::filesystem::exists(file)) return;
    try {
        pfem::markOpenings(Dictionary::read(file), description);
    } catch (const UserError&) {
    }
}

MeshResult makeMesh(const Case& theCase, const MeshDescription& description) {
    if (description.meshFile.empty()) return buildMesh(description);
    const auto file = theCase.root() / description.meshFile;
    if (!std::filesystem::exists(file))
        throw UserError("cannot find file \"" + file.string() + "\"", description.meshFileAt);
    return takeMesh(description, readMeshFile(file, description.cellArray));
}

SpaceMeshResult makeSpaceMesh(const Case& theCase, const SpaceDescription& description) {
    if (description.meshFile.empty()) return buildSpaceMesh(description);
    const auto file = theCase.root() / description.meshFile;
    if (!std::filesystem::exists(file))
        throw UserError("cannot find file \"" + file.string() + "\"", description.places.of("meshFile"));
    return takeSpaceMesh(description, readMeshFile<3>(file, description.cellArray));
}

double memoryPeak() {  // [MB]
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Time 0 and what a user should know of it.
template <int Dim>
void write(const Case& theCase, const State<Dim>& state) {
    writeState(theCase.time("0"), state);
    writeSeries(theCase.root());
    warnOfLaterTimes(theCase);
    checkConditions<Dim>(theCase, state);
}

void meshPlane(const Case& theCase, const Dictionary& dict, double meshSize) {
    MeshDescription description = readMeshDict(dict, materialNames(theCase), meshSize);
    warnUnused(dict, std::cerr);
    markOpenings(theCase, description);
    const MeshResult mesh = makeMesh(theCase, description);
    std::cout << meshReport(description, mesh) << std::flush;
    write<2>(theCase, mesh.state);
}

void meshSpace(const Case& theCase, const Dictionary& dict, double meshSize) {
    SpaceDescription description = readSpaceDict(dict, materialNames(theCase), theCase.root(), meshSize);
    warnUnused(dict, std::cerr);
    markOpenings(theCase, description);
    const SpaceMeshResult mesh = makeSpaceMesh(theCase, description);
    std::cout << spaceReport(description, mesh) << std::flush;
    write<3>(theCase, mesh.state);
}

int run(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const Case theCase = options.openCase();
    std::cout << startBanner(options, theCase) << std::flush;
    const RunLock lock(theCase.root(), options.program());

    const Dictionary dict = Dictionary::read(theCase.system("meshDict"));
    const int dimension = meshDimension(dict, theCase.root());
    (dimension == 3 ? meshSpace : meshPlane)(theCase, dict, meshSizeOption(options));

    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    std::cout << fmt::format("\nWritten 0/\nExecutionTime = {:.2f} s  Memory = {:.0f} MB\n\nEnd\n", elapsed.count(),
                             memoryPeak());
    return 0;
}

}  // namespace

int main(int argc, char* argv[]) {
    OptionsSpec spec;
    spec.add("h", "size",
             "target edge length [m] instead of meshSize at the top of meshDict; "
             "sizes of bodies, walls and refinements keep their ratio to it");
    return runApplication(argc, argv,
                          "Mesh the bodies and walls of system/meshDict, or take the mesh of a file, and write time 0.",
                          spec, run);
}
