#pragma once
// Numbers that laws of materials remember, under their names.

#include <string>
#include <vector>

namespace pfem {

/// Named numbers of each of n points, one point's after the other's. Without names there is nothing.
struct History {
    std::vector<std::string> names;
    std::vector<double> values;

    int width() const { return static_cast<int>(names.size()); }
    bool empty() const { return names.empty(); }

    double& at(int point, int column) { return values[static_cast<std::size_t>(point * width() + column)]; }
    double at(int point, int column) const { return values[static_cast<std::size_t>(point * width() + column)]; }

    /// New points have zeros.
    void resize(int points) { values.resize(static_cast<std::size_t>(points * width()), 0.0); }

    /// Append point i of another history; zeros when that has other names.
    void append(const History& other, int i) {
        for (int k = 0; k < width(); ++k) values.push_back(other.names == names ? other.at(i, k) : 0);
    }

    /// The points with these indices, in their order.
    History taken(const std::vector<int>& indices) const {
        History result{names, {}};
        for (const int i : indices) result.append(*this, i);
        return result;
    }
};

}  // namespace pfem
