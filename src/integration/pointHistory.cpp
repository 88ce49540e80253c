#include "integration/pointHistory.hpp"

namespace pfem {

namespace {

/// Of each cell: the mean of its nodes.
template <int Dim>
History cellMeans(const Patches<Dim>& patches, const History& nodal) {
    History cell{nodal.names, {}};
    cell.resize(patches.nCells());
    for (int e = 0; e < patches.nCells(); ++e)
        for (int k = 0; k < nodal.width(); ++k)
            for (const int node : patches.cell(e)) cell.at(e, k) += nodal.at(node, k) / (Dim + 1);
    return cell;
}

/// At each node of the material: the mean of its patch.
template <int Dim>
History nodalMeans(const Patches<Dim>& patches, const History& cell) {
    const NodeToCells& around = *patches.around;
    History nodal{cell.names, {}};
    nodal.resize(patches.nNodes());
    for (int i = 0; i < patches.nNodes(); ++i)
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            for (int k = 0; k < cell.width(); ++k)
                nodal.at(i, k) += patches.element[around.cell[s]].measure * cell.at(around.cell[s], k) /
                                  ((Dim + 1) * patches.volume[i]);
    return nodal;
}

}  // namespace

template <int Dim>
History storedHistory(const Patches<Dim>& patches, const History& nodal, const History& cell) {
    if (patches.scheme == Integration::nodal) return nodal;
    return cell.empty() ? cellMeans<Dim>(patches, nodal) : cell;
}

template <int Dim>
void storeHistory(const Patches<Dim>& patches, History point, History& nodal, History& cell) {
    if (patches.scheme == Integration::nodal) {
        nodal = std::move(point);
        cell = {};
    } else {
        nodal = nodalMeans<Dim>(patches, point);
        cell = std::move(point);
    }
}

template History storedHistory<2>(const Patches<2>&, const History&, const History&);
template void storeHistory<2>(const Patches<2>&, History, History&, History&);

}  // namespace pfem
