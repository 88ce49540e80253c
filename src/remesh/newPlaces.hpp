#pragma once
// Where the nodes before a remeshing are among those after it; beyond periodic sides, too.

#include "remesh/movedMesh.hpp"
#include "state/unfolding.hpp"

namespace pfem {

template <int Dim>
class NewPlaces {
public:
    /// `index`: of each old node and then of each inserted one, of images their masters', -1: gone. `moved`: by how
    /// many periods the new nodes have been put back. Without periodic sides both images are empty.
    NewPlaces(const Images<Dim>& old, const std::vector<int>& index, std::vector<Shift<Dim>> moved, Images<Dim> now)
        : old_(old), index_(index), moved_(std::move(moved)), now_(std::move(now)) {}

    /// The new node at the place of an old one, or `beyond` from it; -1: none.
    int at(int i, const Shift<Dim>& beyond = {}) const {
        const int node = index_[i];
        if (node < 0 || now_.empty()) return node;
        Shift<Dim> shift = shiftOf<Dim>(i < static_cast<int>(old_.code.size()) ? old_.code[i] : 0);
        for (int k = 0; k < Dim; ++k) {
            shift[k] += beyond[k] - moved_[node][k];
            if (std::abs(shift[k]) > 1) return -1;
        }
        return now_.find(node, codeOf<Dim>(shift));
    }

    /// Values of images are their masters'.
    template <class Value>
    void follow(std::vector<Value>& values) const {
        now_.follow(values);
    }

private:
    const Images<Dim>& old_;
    const std::vector<int>& index_;
    std::vector<Shift<Dim>> moved_;
    Images<Dim> now_;
};

}  // namespace pfem
