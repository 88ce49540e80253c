#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dictionary/function1Types.hpp"

namespace pfem::function1Detail {

template <class T>
Table1<T>::Table1(Pairs<T> points, OutOfBounds outside, Location where)
    : points_(std::move(points)), outside_(outside), where_(std::move(where)) {
    if (points_.empty()) throw UserError("A table needs at least one point (time value)", where_);
    for (std::size_t k = 1; k < points_.size(); ++k)
        if (!(points_[k].first > points_[k - 1].first))
            throw UserError(fmt::format("The times of a table must ascend: {:g} follows {:g}", points_[k].first,
                                        points_[k - 1].first),
                            where_);
    area_.push_back(0 * points_[0].second);
    for (std::size_t k = 1; k < points_.size(); ++k)
        area_.push_back(area_.back() +
                        0.5 * (points_[k].first - points_[k - 1].first) * (points_[k].second + points_[k - 1].second));
}

/// The time in the table that stands for t.
template <class T>
double Table1<T>::within(double t) const {
    const double first = points_.front().first, last = points_.back().first;
    if (t >= first && t <= last) return t;
    if (outside_ == OutOfBounds::error)
        throw UserError(
            fmt::format("Time {:g} is outside the table's range {:g} ... {:g} (outOfBounds error)", t, first, last),
            where_);
    if (outside_ == OutOfBounds::clamp || last == first) return std::clamp(t, first, last);
    const double cycles = (t - first) / (last - first);
    return first + (cycles - std::floor(cycles)) * (last - first);
}

/// Index of the point at or before t (not the last).
template <class T>
std::size_t Table1<T>::piece(double t) const {
    const auto after =
        std::upper_bound(points_.begin(), points_.end(), t, [](double s, const auto& p) { return s < p.first; });
    const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - points_.begin() - 1, 0));
    return std::min(k, points_.size() - 2);
}

template <class T>
T Table1<T>::value(double t) const {
    t = within(t);
    if (points_.size() == 1) return points_[0].second;
    const std::size_t k = piece(t);
    const double s = (t - points_[k].first) / (points_[k + 1].first - points_[k].first);
    return (1 - s) * points_[k].second + s * points_[k + 1].second;
}

template <class T>
T Table1<T>::derivative(double t) const {
    const bool outside = t < points_.front().first || t >= points_.back().first;
    if (points_.size() == 1 || (outside && outside_ != OutOfBounds::repeat)) return 0 * points_[0].second;
    const std::size_t k = piece(within(t));
    return (points_[k + 1].second - points_[k].second) / (points_[k + 1].first - points_[k].first);
}

template <class T>
T Table1<T>::integralFromFirst(double t) const {
    const double first = points_.front().first, last = points_.back().first;
    if (outside_ == OutOfBounds::repeat && last > first) {
        const double cycles = std::floor((t - first) / (last - first));
        const double inside = t - cycles * (last - first);
        const std::size_t k = piece(inside);
        return cycles * area_.back() + area_[k] +
               0.5 * (inside - points_[k].first) * (points_[k].second + value(inside));
    }
    if (t <= first) return (t - first) * points_.front().second;
    if (t >= last) return area_.back() + (t - last) * points_.back().second;
    const std::size_t k = piece(t);
    return area_[k] + 0.5 * (t - points_[k].first) * (points_[k].second + value(t));
}

template <class T>
T Table1<T>::integral(double from, double to) const {
    within(from);
    within(to);
    return integralFromFirst(to) - integralFromFirst(from);
}

template <class T>
double Table1<T>::outOfPlane() const {
    for (const auto& [t, value] : points_)
        if (zOf(value) != 0) return zOf(value);
    return 0;
}

template class Table1<double>;
template class Table1<Eigen::Vector3d>;

}  // namespace pfem::function1Detail
