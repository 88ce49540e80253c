#include "dictionary/function1Types.hpp"

#include <cmath>
#include <numbers>

namespace pfem::function1Detail {

namespace {

double power(double t, double exponent) { return exponent == 0 ? 1 : std::pow(t, exponent); }

/// c t^e, its derivative (order 1) or its integral (order -1).
double term(double c, double e, double t, int order) {
    if (order == 0) return c * power(t, e);
    if (order == 1) return e == 0 ? 0 : c * e * power(t, e - 1);
    return e == -1 ? c * std::log(t) : c * power(t, e + 1) / (e + 1);
}

}  // namespace

template <class T>
T Polynomial<T>::sum(double t, int order) const {
    T total{};
    if constexpr (std::is_same_v<T, double>) {
        total = 0;
        for (const auto& [c, e] : terms_) total += term(c, e, t, order);
    } else {
        total.setZero();
        for (const auto& [c, e] : terms_)
            for (int k = 0; k < 3; ++k) total[k] += term(c[k], e[k], t, order);
    }
    return total;
}

template <class T>
double Polynomial<T>::outOfPlane() const {
    for (const auto& [c, e] : terms_)
        if (zOf(c) != 0) return zOf(c);
    return 0;
}

template <class T>
T Wave<T>::value(double t) const {
    const double cycles = e_.frequency * (t - e_.start);
    double w = 0;
    if (e_.square)
        w = cycles - std::floor(cycles) < e_.markSpace / (1 + e_.markSpace) ? 1 : -1;
    else
        w = std::sin(2 * std::numbers::pi * cycles);
    return e_.level + e_.amplitude->value(t) * w * e_.scale;
}

template <class T>
T Wave<T>::derivative(double t) const {
    const double omega = 2 * std::numbers::pi * e_.frequency, phase = omega * (t - e_.start);
    if (e_.square) return Function1<T>::derivative(t);
    return (e_.amplitude->derivative(t) * std::sin(phase) + e_.amplitude->value(t) * omega * std::cos(phase)) *
           e_.scale;
}

template <class T>
Formula<T>::Formula(const std::vector<std::string>& formulas, const Location& where) {
    for (const auto& text : formulas) components_.emplace_back(text, std::vector<std::string>{"t"}, where);
}

template <class T>
T Formula<T>::value(double t) const {
    if constexpr (std::is_same_v<T, double>)
        return components_[0]({t});
    else
        return {components_[0]({t}), components_[1]({t}), components_[2]({t})};
}

template <class T>
double Formula<T>::outOfPlane() const {
    if (components_.size() < 3) return 0;
    for (const double t : {0.0, 1e-3, 0.017, 0.11, 0.37, 1.3, 7.9, 53.0}) {
        try {
            if (const double z = components_[2]({t}); z != 0) return z;
        } catch (const UserError&) {  // it need not have a value at this time
        }
    }
    return 0;
}

template class Polynomial<double>;
template class Polynomial<Eigen::Vector3d>;
template class Wave<double>;
template class Wave<Eigen::Vector3d>;
template class Formula<double>;
template class Formula<Eigen::Vector3d>;

}  // namespace pfem::function1Detail
