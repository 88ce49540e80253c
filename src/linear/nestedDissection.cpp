#include "linear/nestedDissection.hpp"

#include <algorithm>
#include <numeric>

namespace pfem {

namespace {

constexpr std::ptrdiff_t leaf = 6;  // as many are not divided further
constexpr std::ptrdiff_t fewPlaces = 200;  // more are worth the choice of the better axis

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
        const Iterator middle = begin + (end - begin) / 2;
        int axis = longestAxis(begin, end);
        if (end - begin > fewPlaces) {  // a cut along a pool is long, even where drops fly high above it
            std::ptrdiff_t fewest = 0;
            for (int candidate = 0; candidate < Dim; ++candidate) {
                halve(begin, middle, end, candidate);
                const auto parted = std::count_if(begin, middle, [&](int i) { return meetsOther(i); });
                if (candidate > 0 && parted >= fewest) continue;
                fewest = parted;
                axis = candidate;
            }
        }
        halve(begin, middle, end, axis);
        const Iterator between = std::stable_partition(begin, middle, [&](int i) { return !meetsOther(i); });
        const std::ptrdiff_t first = between - begin, second = end - middle;
        std::rotate(between, middle, end);
        divide(begin, begin + first);
        divide(begin + first, begin + first + second);
    }

    /// Lower half first; the other one gets a new stamp.
    void halve(Iterator begin, Iterator middle, Iterator end, int axis) {
        std::nth_element(begin, middle, end, [&](int a, int b) {
            const double xa = place_[a][axis], xb = place_[b][axis];
            return xa != xb ? xa < xb : a < b;
        });
        ++stamp_;
        for (auto i = middle; i != end; ++i) side_[*i] = stamp_;
    }

    bool meetsOther(int i) const {
        return std::any_of(graph_.neighbour.begin() + graph_.start[i], graph_.neighbour.begin() + graph_.start[i + 1],
                           [&](int j) { return side_[j] == stamp_; });
    }

    /// Along which the places spread most: a few drops far away do not count.
    int longestAxis(Iterator begin, Iterator end) const {
        Place sum = Place::Zero(), squares = Place::Zero();
        for (auto i = begin; i != end; ++i) {
            const Place x = place_[*i] - place_[*begin];
            sum += x;
            squares += x.cwiseProduct(x);
        }
        int axis = 0;
        (squares - sum.cwiseProduct(sum) / static_cast<double>(end - begin)).maxCoeff(&axis);
        return axis;
    }

    const MatrixGraph& graph_;
    const std::vector<Place>& place_;
    std::vector<int> order_;
    std::vector<int> side_;  // stamp of the last second half that the unknown was in
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
