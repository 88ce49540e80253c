#include "parallel/bisection.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace pfem {

namespace {

using Range = std::pair<std::vector<int>::iterator, std::vector<int>::iterator>;

template <int Dim>
int longestAxis(const Points<Dim>& x, const Range& range) {
    if (range.first == range.second) return 0;
    Vec<Dim> least = x[*range.first], most = least;
    for (auto i = range.first; i != range.second; ++i) {
        least = least.cwiseMin(x[*i]);
        most = most.cwiseMax(x[*i]);
    }
    int axis = 0;
    (most - least).maxCoeff(&axis);
    return axis;
}

/// Of the points in `range` and of the region that the cuts before have left.
template <int Dim>
class Divider {
public:
    Divider(const Points<Dim>& x, Bisection<Dim>& result) : x_(x), result_(result) {}

    void divide(Range range, const Region<Dim>& region, int nParts) {
        if (nParts == 1) {
            for (auto i = range.first; i != range.second; ++i)
                result_.owner[*i] = static_cast<int>(result_.regions.size());
            result_.regions.push_back(region);
            return;
        }
        const int nLow = nParts / 2, axis = longestAxis<Dim>(x_, range);
        const auto middle = range.first + (range.second - range.first) * nLow / nParts;
        Region<Dim> low = region, high = region;
        if (middle != range.second) {
            std::nth_element(range.first, middle, range.second,
                             [&](int i, int j) { return std::pair(x_[i][axis], i) < std::pair(x_[j][axis], j); });
            low.to[axis] = high.from[axis] = x_[*middle][axis];
        }
        divide({range.first, middle}, low, nLow);
        divide({middle, range.second}, high, nParts - nLow);
    }

private:
    const Points<Dim>& x_;
    Bisection<Dim>& result_;
};

}  // namespace

template <int Dim>
Bisection<Dim> bisect(const Points<Dim>& x, const std::vector<int>& active, int nParts) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Bisection<Dim> result;
    result.owner.assign(x.size(), -1);
    std::vector<int> points = active;
    Divider<Dim>(x, result).divide({points.begin(), points.end()},
                                   {Vec<Dim>::Constant(-infinity), Vec<Dim>::Constant(infinity)}, nParts);
    return result;
}

#define PFEM_INSTANTIATE(D) template Bisection<D> bisect<D>(const Points<D>&, const std::vector<int>&, int);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
