#pragma once
// The kinds of laws that solids have: cells of different kinds take gradients of different fields in different
// positions.

#include <algorithm>
#include <vector>

#include "conditions/problem.hpp"

namespace pfem {

/// The kinds of laws that the cells have, each once, and that of each cell.
template <int Dim>
class KindsOfLaws {
public:
    KindsOfLaws(const Problem<Dim>& problem, const Cells<Dim>& cells) : cells_(cells) {
        for (const auto& material : problem.materials) {
            const bool solid = material.kind == MaterialKind::solid;
            ofMaterial_.push_back(solid ? material.solid.law->kinematics() : Kinematics::midpoint);
        }
        for (const Kinematics kind : {Kinematics::midpoint, Kinematics::endPoint, Kinematics::reference})
            if (std::any_of(cells.material.begin(), cells.material.end(),
                            [&](int m) { return ofMaterial_[m] == kind; }))
                kinds.push_back(kind);
    }

    std::vector<Kinematics> kinds;

    bool has(Kinematics kind) const { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); }
    bool only(Kinematics kind) const { return kinds.size() == 1 && kinds[0] == kind; }
    Kinematics ofCell(int e) const { return ofMaterial_[cells_.material[e]]; }
    bool isTotal(int e) const { return ofCell(e) == Kinematics::reference; }

    /// `whole` where all cells are of one kind; otherwise put together from a field of each kind: make(kind).
    template <class Make>
    auto perCell(const Make& make) const {
        auto field = make(kinds[0]);
        for (std::size_t k = 1; k < kinds.size(); ++k) {
            const auto other = make(kinds[k]);
            for (int e = 0; e < cells_.size(); ++e)
                if (ofCell(e) == kinds[k]) field[e] = other[e];
        }
        return field;
    }

private:
    const Cells<Dim>& cells_;
    std::vector<Kinematics> ofMaterial_;
};

}  // namespace pfem
