#include "solver/failedFolder.hpp"

#include <fmt/format.h>

#include "base/atomicFile.hpp"
#include "io/stateFiles.hpp"
#include "solver/outputFields.hpp"

namespace pfem {

namespace {

std::string collection(double time) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    int part = 0;
    for (const char* name : {"fluid", "solid", "boundary"})
        text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"{}\" name=\"{}\" file=\"{}.vtu\"/>\n", time,
                            part++, name, name);
    return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace

template <int Dim>
std::string writeFailed(const std::filesystem::path& root, const Problem<Dim>& problem, const FailedStep<Dim>& failure,
                        const State<Dim>& last) {
    const auto folder = root / "failed";
    const Inspection<Dim> found = inspect<Dim>(failure, last);
    ExtraFields extra = outputFields<Dim>(problem, found.state);
    extra.nodalFlags["failed"] = found.failed;
    writeState(folder, found.state, extra);
    writeAtomically(folder / "failed.pvd", collection(last.time.value));
    writeAtomically(folder / "reason", fmt::format("The step after t = {} s failed:\n{}\n{}", last.time.value,
                                                   failure.what(), found.text));
    return found.text;
}

#define PFEM_INSTANTIATE(D)                                                                                    \
    template std::string writeFailed<D>(const std::filesystem::path&, const Problem<D>&, const FailedStep<D>&, \
                                        const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
