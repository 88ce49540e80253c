#include "linear/solvers.hpp"

#include <algorithm>
#include <array>

#include "base/parallel.hpp"
#include "linear/dissectedLdlt.hpp"
#include "linear/ldlt.hpp"

namespace pfem {

namespace {

/// As many as pay: each has an ordering and a factor of its own, and what lies between them grows.
int nParts(int unknowns) { return unknowns < 2000 ? 1 : unknowns < 100000 ? 2 : 4; }

}  // namespace

template <int Dim>
std::vector<int> equalSlabs(const SymmetricMatrix& A, const Places<Dim>& place, int nParts) {
    if (nParts < 2) return std::vector<int>(A.n, 0);
    std::array<std::vector<int>, Dim> part;
    std::array<int, Dim> parted{};
    parallelTasks(Dim, [&](int axis) {
        part[axis] = slabs<Dim>(place, nParts, axis);
        int count = 0;
        for (int j = 0; j < A.n; ++j)
            for (int s = A.start[j]; s < A.start[j + 1]; ++s) count += part[axis][A.row[s]] != part[axis][j];
        parted[axis] = count;
    });
    const auto axis = static_cast<int>(std::min_element(parted.begin(), parted.end()) - parted.begin());
    const auto shared = sharedUnknowns(A, part[axis]);
    const auto perCut = static_cast<int>(std::count(shared.begin(), shared.end(), 1)) / (nParts - 1);
    constexpr int few = 8;  // of a part
    return perCut * few * nParts < A.n ? part[axis] : slabs<Dim>(place, nParts, axis, perCut);
}

template <int Dim>
std::unique_ptr<SymmetricSolver> dissectedSolver(const SymmetricMatrix& A, Places<Dim> place, Precision precision) {
    const int parts = nParts(A.n);
    auto part = equalSlabs<Dim>(A, place, parts);
    if (precision == Precision::twofold)
        return std::make_unique<DissectedLdlt<Dim, double>>(std::move(place), std::move(part), parts);
    if (precision == Precision::singleThroughout)
        return std::make_unique<DissectedLdlt<Dim, float, float>>(std::move(place), std::move(part), parts);
    return std::make_unique<DissectedLdlt<Dim, float>>(std::move(place), std::move(part), parts);
}

template <int Dim>
std::unique_ptr<SymmetricSolver> elasticSolver(const SymmetricMatrix& A, Places<Dim> place, double stiffness) {
    constexpr int large = 3000;
    constexpr double wellConditioned = 1e3;
    if (Dim == 2 && A.n < large) return std::make_unique<Ldlt>();
    const auto inSpace = stiffness < wellConditioned ? Precision::singleThroughout : Precision::single;
    return dissectedSolver<Dim>(A, std::move(place), Dim == 2 ? Precision::twofold : inSpace);
}

#define PFEM_INSTANTIATE(D)                                                                                     \
    template std::vector<int> equalSlabs<D>(const SymmetricMatrix&, const Places<D>&, int);                     \
    template std::unique_ptr<SymmetricSolver> dissectedSolver<D>(const SymmetricMatrix&, Places<D>, Precision); \
    template std::unique_ptr<SymmetricSolver> elasticSolver<D>(const SymmetricMatrix&, Places<D>, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
