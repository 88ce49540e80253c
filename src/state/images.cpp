#include "state/images.hpp"

#include <numeric>
#include <utility>

namespace pfem {

template <int Dim>
int codeOf(const Shift<Dim>& shift) {
    int code = 0;
    for (int k = Dim - 1; k >= 0; --k) code = 3 * code + (shift[k] + 3) % 3;
    return code;
}

template <int Dim>
Shift<Dim> shiftOf(int code) {
    Shift<Dim> shift;
    for (int k = 0; k < Dim; ++k, code /= 3) shift[k] = code % 3 == 2 ? -1 : code % 3;
    return shift;
}

template <int Dim>
int Images<Dim>::find(int ofMaster, int withCode) const {
    if (withCode == 0) return ofMaster;
    const std::pair wanted(withCode, ofMaster);
    const auto of = [&](int i) { return std::pair(code[i], master[i]); };
    int low = nOwn, high = static_cast<int>(master.size());
    while (low < high) {
        const int middle = (low + high) / 2;
        if (of(middle) < wanted)
            low = middle + 1;
        else
            high = middle;
    }
    if (low < static_cast<int>(master.size()) && of(low) == wanted) return low;
    return -1;
}

template <int Dim>
Images<Dim> imagesOf(const State<Dim>& state) {
    Images<Dim> images;
    const auto& id = state.nodes.id;
    images.nOwn = nOwnNodes<Dim>(state);
    if (images.nOwn == state.nodes.size()) return images;
    images.master.resize(id.size());
    images.code.assign(id.size(), 0);
    std::iota(images.master.begin(), images.master.begin() + images.nOwn, 0);
    for (std::size_t i = images.nOwn; i < id.size(); ++i) {
        const auto master = std::lower_bound(id.begin(), id.begin() + images.nOwn, id[i] % firstImage);
        images.master[i] = static_cast<int>(master - id.begin());
        images.code[i] = static_cast<int>(id[i] / firstImage);
    }
    return images;
}

template <int Dim>
std::vector<Shift<Dim>> shiftsOf(const Period<Dim>& period) {
    std::vector<Shift<Dim>> all;
    for (int code = 1; code < (Dim == 2 ? 9 : 27); ++code) {
        const auto shift = shiftOf<Dim>(code);
        bool possible = true;
        for (int k = 0; k < Dim; ++k) possible = possible && (shift[k] == 0 || period.length[k] > 0);
        if (possible) all.push_back(shift);
    }
    return all;
}

template <int Dim>
bool namesAreValid(const State<Dim>& state) {
    const auto images = imagesOf<Dim>(state);
    const auto& nodes = state.nodes;
    if (images.nOwn > 0 && nodes.id[images.nOwn - 1] >= state.nextId) return false;
    for (int i = images.nOwn; i < nodes.size(); ++i) {
        const int m = images.master[i];
        if (state.nextId <= 0 || m == images.nOwn || nodes.id[m] != nodes.id[i] % firstImage ||
            nodes.v[m] != nodes.v[i] || nodes.p[m] != nodes.p[i])
            return false;
    }
    return true;
}

#define PFEM_INSTANTIATE(D)                          \
    template int codeOf<D>(const Shift<D>&);         \
    template Shift<D> shiftOf<D>(int);               \
    template struct Images<D>;                       \
    template Images<D> imagesOf<D>(const State<D>&); \
    template bool namesAreValid<D>(const State<D>&); \
    template std::vector<Shift<D>> shiftsOf<D>(const Period<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
