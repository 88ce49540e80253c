// `type surfaceLength`: the length of the free surface, as a function object of one's own in one file.
//
//     surface { type surfaceLength; scale 100; }      // in cm

#include <optional>

#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "io/table.hpp"
#include "mesh/simplex.hpp"
#include "mesh/topology.hpp"
#include "solver/setup.hpp"

using namespace pfem;

namespace {

struct SurfaceLengthEntries {
    double scale = 1;

    template <class Visitor>
    void entries(Visitor& v) {
        v("scale", scale, "-", "factor of the length", positive);
    }
};

/// Writes postProcessing/<name>/<startTime>/surfaceLength.dat: time and length [m].
class SurfaceLength : public FunctionObject<2> {
public:
    SurfaceLength(const Dictionary& dict, const FunctionContext<2>& context)
        : context_(context), entries_(readEntries<SurfaceLengthEntries>(dict)) {}

    void start(const State<2>& state) override {
        kinds_ = readProblem<2>(Case(context_.root), state, nullptr).conditions.kind;
        table_.emplace(context_.folder / "surfaceLength.dat", context_.precision, context_.resumeAt);
        table_->header({"Time", "length"});
    }

    void execute(const State<2>& state) override {
        double length = 0;
        for (const auto& face : makeTopology<2>(state.mesh, kinds_, state.nodes.x, state.nodes.wall).faces)
            if (face.kind == FaceKind::freeSurface) length += faceArea<2>(state.nodes.x, face.nodes).norm();
        table_->row({table_->time(state.time.value), table_->number(entries_.scale * length)});
    }

private:
    FunctionContext<2> context_;
    SurfaceLengthEntries entries_;
    std::vector<PatchKind> kinds_;
    std::optional<Table> table_;
};

const bool added = addFunctionType<2>("surfaceLength", [](const Dictionary& dict, const FunctionContext<2>& context) {
    return std::unique_ptr<FunctionObject<2>>(new SurfaceLength(dict, context));
});

}  // namespace
