#include "functions/line.hpp"

#include <fmt/format.h>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "case/timeFolders.hpp"
#include "functions/sampling.hpp"
#include "functions/sensors.hpp"

namespace pfem {

template <int Dim>
Line<Dim>::Line(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    readEntries(dict, entries_);
    fields_ = nodalFields<Dim>(dict, entries_.fields);
    if (!((entries_.end - entries_.start).template head<Dim>().norm() > 0))
        dict.fatal("end", "start and end of the line are the same point");
    warnOutOfPlane<Dim>(dict, "start", {entries_.start});
    warnOutOfPlane<Dim>(dict, "end", {entries_.end});
}

template <int Dim>
void Line<Dim>::execute(const State<Dim>& state) {
    std::string text = "# distance x y z", file = "line";
    for (const auto& field : fields_) {
        file += "_" + field.name;
        for (int c = 0; c < field.components; ++c)
            text += field.components == 1 ? " " + field.name : fmt::format(" {}[{}]", field.name, c);
    }
    text += "\n";
    for (int k = 0; k < entries_.nPoints; ++k) {
        const double part = static_cast<double>(k) / (entries_.nPoints - 1);
        const Eigen::Vector3d point = (1 - part) * entries_.start + part * entries_.end;
        const Samples<Dim> at = sampleAt<Dim>(state, point.head<Dim>());
        text += fmt::format("{:.{}g} {:.{}g} {:.{}g} {:.{}g}", part * (entries_.end - entries_.start).norm(),
                            context_.precision, point[0], context_.precision, point[1], context_.precision, point[2],
                            context_.precision);
        for (const auto& field : fields_)
            for (const double value : sampledValue<Dim>(field, state.nodes, at, dry))
                text += fmt::format(" {:.{}g}", value, context_.precision);
        text += "\n";
    }
    const auto folder = context_.folder.parent_path() / timeName(state.time.value, "general", 12);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw UserError("cannot make the folder \"" + folder.string() + "\": " + error.message());
    writeAtomically(folder / (file + ".xy"), text);
}

#define PFEM_INSTANTIATE(D) template class Line<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
