#pragma once
// `type surfaces`: cuts through the case, the free surface and the solids' skin, for ParaView.

#include "dictionary/entries.hpp"
#include "functions/fields.hpp"
#include "functions/functionObject.hpp"
#include "functions/planeCut.hpp"
#include "io/surfaceSeries.hpp"
#include "mesh/topology.hpp"

namespace pfem {

struct SurfacesEntries {
    std::vector<std::string> fields;
    std::vector<std::vector<Eigen::Vector3d>> planes;
    bool freeSurface = false;
    bool solidSkin = false;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("fields", fields, "-", "what the surfaces carry: U a D p sigma h; 0 where one has no meaning");
        v("planes", planes, "m",
          "cuts through fluid and solids (2D: along lines), each a point and a normal: (((0.5 0 0) (1 0 0))); the "
          "files "
          "plane0, plane1, ...");
        v("freeSurface", freeSurface, "-", "the free surface of the fluid, without drops in flight: freeSurface");
        v("solidSkin", solidSkin, "-", "the boundary of the solids, with p of the fluid that touches it: solidSkin");
    }
};

/// Writes postProcessing/<name>/<time>/<surface>.vtp and the lists postProcessing/<name>/<surface>.vtp.series. Lines in
/// 2D, polygons in 3D; fields are interpolated linearly, which is what they are in the cells.
template <int Dim>
class Surfaces : public FunctionObject<Dim> {
public:
    Surfaces(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    FunctionContext<Dim> context_;
    SurfacesEntries entries_;
    std::vector<NodalField<Dim>> fields_;
    std::vector<Plane<Dim>> planes_;
    std::vector<PatchKind> kinds_;
    std::vector<SurfaceSeries> series_;  // planes, free surface, skin
};

/// The plane through a point, its normal made a unit vector. UserError at `key` for a normal without length and, in 2D,
/// one out of the plane of x and y.
template <int Dim>
Plane<Dim> planeOf(const Dictionary& dict, const std::string& key, const Eigen::Vector3d& point,
                   const Eigen::Vector3d& normal);

}  // namespace pfem
