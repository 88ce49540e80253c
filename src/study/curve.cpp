#include "study/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pfem {

double valueAt(const Curve& curve, double t) {
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    if (curve.t.empty() || !(t >= curve.t.front()) || t > curve.t.back()) return missing;
    const auto next = std::lower_bound(curve.t.begin(), curve.t.end(), t);
    const auto i = static_cast<std::size_t>(next - curve.t.begin());
    if (curve.t[i] == t) return curve.y[i];
    const double part = (t - curve.t[i - 1]) / (curve.t[i] - curve.t[i - 1]);
    return curve.y[i - 1] + part * (curve.y[i] - curve.y[i - 1]);
}

std::vector<double> valuesAt(const Curve& curve, const std::vector<double>& t) {
    std::vector<double> values;
    for (const double now : t) values.push_back(valueAt(curve, now));
    return values;
}

std::vector<double> commonTimes(const std::vector<Curve>& curves) {
    double from = -std::numeric_limits<double>::infinity(), to = -from;
    std::vector<double> all;
    for (const Curve& curve : curves) {
        if (curve.t.empty()) return {};
        from = std::max(from, curve.t.front());
        to = std::min(to, curve.t.back());
        all.insert(all.end(), curve.t.begin(), curve.t.end());
    }
    std::erase_if(all, [&](double t) { return t < from || t > to; });
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::vector<double> weights(const std::vector<double>& t) {
    std::vector<double> w(t.size(), 0.0);
    for (std::size_t i = 1; i < t.size(); ++i) {
        w[i - 1] += 0.5 * (t[i] - t[i - 1]);
        w[i] += 0.5 * (t[i] - t[i - 1]);
    }
    return w;
}

std::vector<Span> spansWhere(const std::vector<double>& t, const std::vector<bool>& flag) {
    std::vector<Span> spans;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (!flag[i]) continue;
        const double to = i + 1 < t.size() ? 0.5 * (t[i] + t[i + 1]) : t[i];
        if (i > 0 && flag[i - 1])
            spans.back().to = to;
        else
            spans.push_back({i > 0 ? 0.5 * (t[i - 1] + t[i]) : t[i], to});
    }
    return spans;
}

double fractionWhere(const std::vector<double>& t, const std::vector<bool>& flag) {
    const auto w = weights(t);
    double part = 0, whole = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        whole += w[i];
        if (flag[i]) part += w[i];
    }
    return whole > 0 ? part / whole : 0;
}

}  // namespace pfem
