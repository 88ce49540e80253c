#include "momentum/boundaryConditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// Mean normal of the faces that a node belongs to; zero where they differ by more than 20 degrees.
template <int Dim>
struct NormalCollector {
    std::vector<Vec<Dim>> sum;
    std::vector<unsigned char> corner;

    explicit NormalCollector(std::size_t n) : sum(n, Vec<Dim>::Zero()), corner(n, 0) {}

    void add(int node, const Vec<Dim>& n) {
        if (sum[node].squaredNorm() > 0 && sum[node].normalized().dot(n) < std::cos(20 * M_PI / 180)) corner[node] = 1;
        sum[node] += n;
    }
    bool isCorner(int node) const { return corner[node] != 0; }
    Vec<Dim> normal(int node) const {
        return corner[node] || sum[node].squaredNorm() == 0 ? Vec<Dim>(Vec<Dim>::Zero())
                                                            : Vec<Dim>(sum[node].normalized());
    }
};

/// c_f / width of `type sideWalls`.
double readSideFriction(const Dictionary& entry) {
    const double width = entry.get<double>("width"), friction = entry.get<double>("friction");
    if (!(width > 0)) entry.fatal("width", "Entry 'width' must be positive");
    if (!(friction >= 0)) entry.fatal("friction", "Entry 'friction' must not be negative");
    return friction / width;
}

/// Every patch needs an entry: those without are named all at once.
void demandEntries(const Dictionary& dict, const std::vector<std::string>& names) {
    std::vector<std::string> missing;
    for (const auto& name : names)
        if (!dict.found(name)) missing.push_back("'" + name + "'");
    if (missing.empty()) return;
    throw UserError(
        fmt::format(
            "No entry for {} of the mesh: each wall and each named patch needs one, of its name or of a pattern "
            "such as \"wall.*\"",
            fmt::join(missing, ", ")),
        dict.where());
}

}  // namespace

template <int Dim>
BoundaryConditions<Dim> readBoundaryConditions(const Dictionary& dict, const std::vector<Patch<Dim>>& patches) {
    static const std::vector<std::string> words = {"slip", "noSlip", "clamped", "symmetry", "traction"};
    BoundaryConditions<Dim> result;
    std::vector<std::string> names;
    for (const auto& patch : patches) names.push_back(patch.name);
    for (const auto& key : dict.keys()) {
        if (key == "FoamFile" || !dict.isDict(key) || std::find(names.begin(), names.end(), key) != names.end())
            continue;
        const Dictionary& entry = dict.subDict(key);
        if (Dim != 2 || !entry.found("type") || entry.get<std::string>("type") != "sideWalls")
            dict.fatal(key, notValid(key, "patch", names));
        result.sideFriction += readSideFriction(entry);
    }
    demandEntries(dict, names);

    for (const auto& patch : patches) {
        const Dictionary& entry = dict.subDict(patch.name);
        const std::string type = entry.choice("type", words);
        result.traction.push_back(Vec<Dim>::Zero());
        result.tractionOverTime.push_back(nullptr);
        result.motion.push_back(nullptr);
        if (entry.found("motion")) {
            if (type == "symmetry" || type == "traction")
                entry.fatal("motion",
                            "'" + patch.name + "' cannot be moved: only slip, noSlip and clamped patches can");
            result.motion.back() = std::make_shared<WallMotion>(entry.subDict("motion"), Dim == 2);
        }
        result.friction.push_back(entry.get<double>("friction", 0));
        if (entry.found("friction") && type != "slip")
            entry.fatal("friction", "'" + patch.name + "' is not a slip wall: only those have 'friction'");
        if (!(result.friction.back() >= 0)) entry.fatal("friction", "Entry 'friction' must not be negative");
        if (type == "slip") result.kind.push_back(PatchKind::slipWall);
        if (type == "noSlip") result.kind.push_back(PatchKind::noSlipWall);
        if (type == "clamped") result.kind.push_back(PatchKind::clamped);
        if (type == "symmetry") result.kind.push_back(PatchKind::symmetry);
        if (type == "traction") {
            result.kind.push_back(PatchKind::traction);
            const auto overTime =
                Dim == 2 ? readPlaneFunction1(entry, "traction") : readFunction1<Eigen::Vector3d>(entry, "traction");
            result.traction.back() = overTime->value(0).template head<Dim>();
            const bool constant = !entry.isDict("traction") && entry.reader("traction").opens();
            if (!constant) result.tractionOverTime.back() = overTime;
        }
    }
    return result;
}

template <int Dim>
NodeConstraints<Dim> nodeConstraints(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions,
                                     const Topology<Dim>& topology, const Nodes<Dim>& nodes, double t0, double t1) {
    const std::size_t n = nodes.x.size();
    NodeConstraints<Dim> c;
    c.hold.assign(n, Hold::free);
    c.normal.assign(n, Vec<Dim>::Zero());
    c.mover.assign(n, -1);
    for (const auto& motion : conditions.motion)
        c.motion.push_back(motion ? motion->template step<Dim>(t0, t1) : RigidStep<Dim>());
    const auto moverOf = [&](int patch) { return conditions.motion[patch] ? patch : -1; };

    NormalCollector<Dim> symmetry(n);
    std::vector<unsigned char> clamped(n, 0), slides(n, 0);
    for (std::size_t k = 0; k < mesh.patches.size(); ++k)
        for (const auto& face : mesh.patches[k].faces)
            for (int node : face) {
                if (conditions.kind[k] == PatchKind::clamped) clamped[node] = 1;
                if (conditions.motion[k]) c.mover[node] = static_cast<int>(k);
                if (conditions.kind[k] != PatchKind::symmetry) continue;
                slides[node] = 1;
                symmetry.add(node, faceArea<Dim>(nodes.X, face).normalized());
            }

    for (std::size_t i = 0; i < n; ++i) {
        const int node = static_cast<int>(i);
        if (slides[i]) {
            c.hold[i] = symmetry.isCorner(node) ? Hold::fixed : Hold::slide;
            c.normal[i] = symmetry.normal(node);
        }
        if (topology.onWall[i]) {
            const auto& wall = topology.walls[nodes.wall[i]];
            // the contact line creeps on, a drop stays where it is
            const bool sticks = conditions.kind[wall.patch] == PatchKind::noSlipWall && !topology.freeSurface[i];
            c.hold[i] = sticks ? Hold::fixed : Hold::slide;
            c.normal[i] = faceArea<Dim>(nodes.x, wall.nodes).normalized();
            if (!topology.corner[i]) c.mover[i] = moverOf(wall.patch);
            if (c.isMoved(node)) c.normal[i] = (c.motion[c.mover[i]].rotation * c.normal[i]).eval();
        }
        if (clamped[i] || topology.corner[i]) c.hold[i] = Hold::fixed;
    }
    return c;
}

#define PFEM_INSTANTIATE(D)                                                                                          \
    template BoundaryConditions<D> readBoundaryConditions<D>(const Dictionary&, const std::vector<Patch<D>>&);       \
    template NodeConstraints<D> nodeConstraints<D>(const Mesh<D>&, const BoundaryConditions<D>&, const Topology<D>&, \
                                                   const Nodes<D>&, double, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
