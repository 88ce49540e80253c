#pragma once
// `type line`: fields along a straight line.

#include "dictionary/entries.hpp"
#include "functions/fields.hpp"
#include "functions/functionObject.hpp"

namespace pfem {

struct LineEntries {
    std::vector<std::string> fields;
    Eigen::Vector3d start{0, 0, 0}, end{0, 0, 0};
    int nPoints = 100;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("fields", fields, "-", "what is sampled: U a D p sigma h");
        v.required("start", start, "m", "first point");
        v.required("end", end, "m", "last point");
        v("nPoints", nPoints, "-", "points at equal distances, both ends included", atLeast(2));
    }
};

/// Writes postProcessing/<name>/<time>/line_<fields>.xy for each sampled time, as OpenFOAM's sets in raw
/// format: a row per point with its distance from `start`, x, y, z and the components of the fields; -1e+300
/// where a field has no material.
template <int Dim>
class Line : public FunctionObject<Dim> {
public:
    Line(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>&) override {}
    void execute(const State<Dim>& state) override;

private:
    FunctionContext<Dim> context_;
    LineEntries entries_;
    std::vector<NodalField<Dim>> fields_;
};

}  // namespace pfem
