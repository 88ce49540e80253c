#include "io/series.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "case/timeFolders.hpp"
#include "io/atomicFile.hpp"

namespace pfem {

namespace {

const std::array<std::string, 3> parts{"fluid", "solid", "boundary"};

std::string collection(const std::vector<TimeFolder>& times) {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (const auto& time : times)
        for (std::size_t part = 0; part < parts.size(); ++part)
            text += fmt::format(
                "    <DataSet timestep=\"{0}\" group=\"\" part=\"{1}\" name=\"{2}\" file=\"{0}/{2}.vtu\"/>\n",
                time.name, part, parts[part]);
    return text + "  </Collection>\n</VTKFile>\n";
}

std::string series(const std::vector<TimeFolder>& times, const std::string& part) {
    std::string text = "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [";
    const char* separator = "\n";
    for (const auto& time : times) {
        text += fmt::format("{}    {{ \"name\" : \"{}/{}.vtu\", \"time\" : {} }}", separator, time.name, part,
                            time.value);
        separator = ",\n";
    }
    return text + "\n  ]\n}\n";
}

}  // namespace

void writeSeries(const std::filesystem::path& root) {
    const auto times = listTimes(root).complete;
    writeAtomically(root / "case.pvd", collection(times));
    for (const auto& part : parts) writeAtomically(root / (part + ".vtu.series"), series(times, part));
}

}  // namespace pfem
