#include "remesh/keepMomentum.hpp"

#include <algorithm>
#include <numeric>

#include "mesh/simplex.hpp"
#include "state/images.hpp"

namespace pfem {

namespace {

/// A cell that is not in both meshes.
template <int Dim>
struct ChangedCell {
    Simplex<Dim> nodes;  // new indices, of those that went n + the old one; masters, sorted
    Simplex<Dim> cell;   // as in its mesh
    bool old, dropped;
    double measure = 0;
    Vec<Dim> momentum = Vec<Dim>::Zero();  // over rho
};

template <int Dim, class Name>
ChangedCell<Dim> namedCell(const Simplex<Dim>& cell, bool old, bool dropped, Name name) {
    ChangedCell<Dim> result{cell, cell, old, dropped};
    for (int& i : result.nodes) i = name(i);
    std::sort(result.nodes.begin(), result.nodes.end());
    return result;
}

template <int Dim>
bool before(const ChangedCell<Dim>& a, const ChangedCell<Dim>& b) {
    return a.nodes < b.nodes;
}

/// Those of `all` that are not in both meshes; contacts, in neither, go with them.
template <int Dim>
std::vector<ChangedCell<Dim>> changedCells(std::vector<ChangedCell<Dim>> all,
                                           const std::vector<CellChange<Dim>>& changes, const Images<Dim>& images) {
    std::vector<Simplex<Dim>> contacts;
    for (const auto& change : changes)
        if (change.amount > 0)
            contacts.push_back(namedCell<Dim>(change.cell, false, false, [&](int i) { return images.own(i); }).nodes);
    std::sort(contacts.begin(), contacts.end());
    std::stable_sort(all.begin(), all.end(), before<Dim>);
    std::vector<ChangedCell<Dim>> changed;
    for (auto from = all.begin(); from != all.end();) {
        const auto to = std::upper_bound(from, all.end(), *from, before<Dim>);
        if (to - from == 1 && !std::binary_search(contacts.begin(), contacts.end(), from->nodes))
            changed.push_back(*from);
        from = to;
    }
    return changed;
}

template <int Dim>
void weigh(const Points<Dim>& x, const Points<Dim>& v, ChangedCell<Dim>& c) {
    c.measure = simplexMeasure<Dim>(x, c.cell);
    for (const int i : c.cell) c.momentum += c.measure / (Dim + 1) * v[i];
}

/// The region of each cell, named by its first: cells that share faces, old or new.
template <int Dim>
std::vector<int> regionsOf(const std::vector<ChangedCell<Dim>>& cells) {
    std::vector<int> region(cells.size());
    std::iota(region.begin(), region.end(), 0);
    const auto rootOf = [&](int k) {
        while (region[k] != k) k = region[k] = region[region[k]];
        return k;
    };
    std::vector<std::pair<Face<Dim>, int>> faces;
    for (std::size_t k = 0; k < cells.size(); ++k)
        for (int left = 0; left <= Dim; ++left) {
            Face<Dim> face;
            for (int c = 0; c < Dim; ++c) face[c] = cells[k].nodes[c + (c >= left)];
            faces.push_back({face, static_cast<int>(k)});
        }
    std::sort(faces.begin(), faces.end());
    for (std::size_t f = 1; f < faces.size(); ++f) {
        if (faces[f].first != faces[f - 1].first) continue;
        const int a = rootOf(faces[f].second), b = rootOf(faces[f - 1].second);
        region[std::max(a, b)] = std::min(a, b);
    }
    for (std::size_t k = 0; k < region.size(); ++k) region[k] = rootOf(static_cast<int>(k));
    return region;
}

/// Volume and momentum, over rho, of a region before and after.
template <int Dim>
struct Region {
    double volume[2] = {0, 0}, taken = 0;  // taken: of the new cells
    Vec<Dim> momentum[2] = {Vec<Dim>::Zero(), Vec<Dim>::Zero()};

    /// d; zero within round-off.
    Vec<Dim> missing() const {
        if (!(volume[0] > 0 && taken > 0)) return Vec<Dim>::Zero();
        const Vec<Dim> wanted = volume[1] / volume[0] * momentum[0], d = wanted - momentum[1];
        return d.norm() > 1e-12 * wanted.norm() ? d : Vec<Dim>(Vec<Dim>::Zero());
    }
};

}  // namespace

template <int Dim>
Points<Dim> missingVelocity(const MovedMesh<Dim>& moved, const Points<Dim>& vOld, int nOwnCells,
                            const std::vector<int>& newIndex, const std::vector<CellChange<Dim>>& changes,
                            const State<Dim>& state) {
    const auto& nodes = state.nodes;
    const int n = nodes.size();
    const auto images = imagesOf<Dim>(state);
    const auto nameNew = [&](int i) { return images.own(i); };
    const auto nameOld = [&](int i) { return newIndex[i] >= 0 ? images.own(newIndex[i]) : n + moved.images.own(i); };
    std::vector<ChangedCell<Dim>> all;
    for (int e = 0; e < nOwnCells; ++e) all.push_back(namedCell<Dim>(moved.fluid[e], true, false, nameOld));
    for (const auto& cell : state.mesh.fluid.nodes) all.push_back(namedCell<Dim>(cell, false, false, nameNew));
    for (const auto& change : changes)
        if (change.amount < 0) all.push_back(namedCell<Dim>(change.cell, false, true, nameNew));
    auto cells = changedCells<Dim>(std::move(all), changes, images);
    const auto regionOf = regionsOf<Dim>(cells);
    std::vector<Region<Dim>> regions(cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
        auto& c = cells[k];
        weigh<Dim>(c.old ? moved.x : nodes.x, c.old ? vOld : nodes.v, c);
        auto& region = regions[regionOf[k]];
        region.volume[c.old ? 0 : 1] += c.measure;
        region.momentum[c.old ? 0 : 1] += c.momentum;
        if (!c.old && !c.dropped) region.taken += c.measure;
    }
    std::vector<double> patch(n, 0.0);
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int i : cell) patch[images.own(i)] += simplexMeasure<Dim>(nodes.x, cell) / (Dim + 1);
    Points<Dim> dv(n, Vec<Dim>::Zero());
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const auto& c = cells[k];
        const auto& region = regions[regionOf[k]];
        if (c.old || c.dropped) continue;
        const Vec<Dim> part = c.measure / (Dim + 1) / region.taken * region.missing();
        for (const int i : c.nodes)
            if (patch[i] > 0) dv[i] += part / patch[i];
    }
    return dv;
}

#define PFEM_INSTANTIATE(D)                                                                                    \
    template Points<D> missingVelocity<D>(const MovedMesh<D>&, const Points<D>&, int, const std::vector<int>&, \
                                          const std::vector<CellChange<D>>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
