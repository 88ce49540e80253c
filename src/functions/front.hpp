#pragma once
// `type front`: how far the fluid has come.

#include <optional>

#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "io/table.hpp"

namespace pfem {

struct FrontEntries {
    Eigen::Vector3d direction{1, 0, 0};

    template <class Visitor>
    void entries(Visitor& v) {
        v("direction", direction, "-", "in which the front is sought: the largest x . direction");
    }
};

struct FrontReading {
    double connected = 0;  // largest x . direction of the main body of fluid [m]
    int node = -1;         // where
    double any = 0;        // of all fluid, drops and separated pieces included [m]
};

/// The main body: the cells that hang together through common nodes and have the largest volume of all such
/// pieces. Nothing without a fluid cell. `direction`: a unit vector.
template <int Dim>
std::optional<FrontReading> readFront(const State<Dim>& state, const Vec<Dim>& direction);

/// Writes postProcessing/<name>/<startTime>/front.dat: time, front of the main body, of any fluid, and the
/// place of the first; -1e+300 when there is no fluid.
template <int Dim>
class Front : public FunctionObject<Dim> {
public:
    Front(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    FunctionContext<Dim> context_;
    FrontEntries entries_;
    std::optional<Table> table_;
};

}  // namespace pfem
