#pragma once
// Rows of the gradient operators, where a matrix needs them.

#include <algorithm>

#include "integration/stressPoints.hpp"

namespace pfem {

/// One row of a gradient operator: nodes and Omega G_J (or |e| grad N_J).
template <int Dim>
struct GradientRow {
    std::vector<int> nodes;
    std::vector<Vec<Dim>> weighted;
    double volume = 0;

    void add(int node, const Vec<Dim>& g) {
        const auto found = std::find(nodes.begin(), nodes.end(), node);
        if (found != nodes.end()) {
            weighted[found - nodes.begin()] += g;
        } else {
            nodes.push_back(node);
            weighted.push_back(g);
        }
    }
};

/// Row of element e: |e| grad N_J.
template <int Dim>
GradientRow<Dim> elementRow(const SmoothingDomains<Dim>& domains, int e) {
    GradientRow<Dim> row;
    const auto& g = domains.element[e];
    row.volume = g.measure;
    for (int k = 0; k <= Dim; ++k) row.add(domains.cell(e)[k], g.measure * g.gradN[k]);
    return row;
}

/// Row of stress point p: Omega G_pJ, for a nodal patch sum_e |e|/(d+1) grad N_J.
template <int Dim>
GradientRow<Dim> pointRow(const SmoothingDomains<Dim>& domains, int p) {
    if (domains.scheme == Integration::elemental) return elementRow<Dim>(domains, p);
    GradientRow<Dim> row;
    row.volume = domains.volume[p];
    const NodeToCells& around = *domains.around;
    for (int s = around.start[p]; s < around.start[p + 1]; ++s) {
        const auto& g = domains.element[around.cell[s]];
        const auto& cell = domains.cell(around.cell[s]);
        for (int k = 0; k <= Dim; ++k) row.add(cell[k], g.measure / (Dim + 1) * g.gradN[k]);
    }
    return row;
}

}  // namespace pfem
