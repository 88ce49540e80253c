#include "linear/nestedDissection.hpp"

#include <algorithm>
#include <numeric>

namespace pfem {

namespace {

constexpr std::ptrdiff_t leaf = 6;  // as many are not divided further

template <int Dim>
class Dissection {
public:
    using Place = Eigen::Matrix<double, Dim, 1>;

    Dissection(const MatrixGraph& graph, const std::vector<Place>& place)
        : graph_(graph), place_(place), order_(place.size()), side_(place.size(), -1) {
        std::iota(order_.begin(), order_.end(), 0);
    }

    std::vector<int> order() {
        divide(order_.begin(), order_.end());
        return std::move(order_);
    }

private:
    using Iterator = std::vector<int>::iterator;

    void divide(Iterator begin, Iterator end) {
        if (end - begin <= leaf) return;
        const int axis = longestAxis(begin, end);
        const Iterator middle = begin + (end - begin) / 2;
        std::nth_element(begin, middle, end, [&](int a, int b) {
            const double xa = place_[a][axis], xb = place_[b][axis];
            return xa != xb ? xa < xb : a < b;
        });
        const int other = stamp_++;
        for (auto i = middle; i != end; ++i) side_[*i] = other;
        const auto meets = [&](int i) {
            return std::any_of(graph_.neighbour.begin() + graph_.start[i], graph_.neighbour.begin() + graph_.start[i + 1],
                               [&](int j) { return side_[j] == other; });
        };
        const Iterator between = std::stable_partition(begin, middle, [&](int i) { return !meets(i); });
        const std::ptrdiff_t first = between - begin, second = end - middle;
        std::rotate(between, middle, end);
        divide(begin, begin + first);
        divide(begin + first, begin + first + second);
    }

    int longestAxis(Iterator begin, Iterator end) const {
        Place low = place_[*begin], high = low;
        for (auto i = begin; i != end; ++i) {
            low = low.cwiseMin(place_[*i]);
            high = high.cwiseMax(place_[*i]);
        }
        int axis = 0;
        (high - low).maxCoeff(&axis);
        return axis;
    }

    const MatrixGraph& graph_;
    const std::vector<Place>& place_;
    std::vector<int> order_;
    std::vector<int> side_;  // the last second half that the unknown was in
    int stamp_ = 0;
};

}  // namespace

template <int Dim>
std::vector<int> nestedDissection(const MatrixGraph& graph, const std::vector<Eigen::Matrix<double, Dim, 1>>& place) {
    return Dissection<Dim>(graph, place).order();
}

template std::vector<int> nestedDissection<2>(const MatrixGraph&, const std::vector<Eigen::Matrix<double, 2, 1>>&);
template std::vector<int> nestedDissection<3>(const MatrixGraph&, const std::vector<Eigen::Matrix<double, 3, 1>>&);

}  // namespace pfem
