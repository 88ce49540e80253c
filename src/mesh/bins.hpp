#pragma once
// Uniform square bins over a box: what lies near a place, without looking at everything.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// Items are numbers that have a box. Bins keep them in the order in which they came; one that touches several bins is
/// in all of them. Whatever lies outside of the whole box counts to the bins at its rim.
template <int Dim>
class Bins {
public:
    /// Bins of this width from `low` on until `high` is covered; wider where there would be too many.
    Bins(const Vec<Dim>& low, const Vec<Dim>& high, double width) : low_(low) {
        constexpr double mostPerAxis = 4000;  // bounds the memory
        width_ = std::max(width, (high - low).maxCoeff() / mostPerAxis);
        if (!(width_ > 0)) width_ = 1;
        std::size_t total = 1;
        for (int d = 0; d < Dim; ++d) {
            count_[d] = static_cast<int>((high[d] - low[d]) / width_) + 1;
            total *= static_cast<std::size_t>(count_[d]);
        }
        chain_.assign(total, {-1, -1});
    }

    /// Bins over the box of all points.
    Bins(const Points<Dim>& x, double width) : Bins(lowest(x), highest(x), width) {}

    /// Put `item` into all bins that the box from `low` to `high` touches.
    void add(int item, const Vec<Dim>& low, const Vec<Dim>& high) {
        visit(low, high, [&](Chain& chain) {
            const int next = static_cast<int>(entry_.size());
            (chain.first < 0 ? chain.first : entry_[chain.last].next) = next;
            chain.last = next;
            entry_.push_back({item, -1});
            return true;
        });
    }

    /// Visit with f(item) what is in the bins touched by the box, each bin after the other, until f gives true; an item
    /// in several bins comes several times. Was there a true?
    template <class F>
    bool any(const Vec<Dim>& low, const Vec<Dim>& high, F&& f) const {
        return !visit(low, high, [&](const Chain& chain) {
            for (int k = chain.first; k >= 0; k = entry_[k].next)
                if (f(entry_[k].item)) return false;
            return true;
        });
    }

    /// f(item) for everything in the bins touched by the box.
    template <class F>
    void parallelFor(const Vec<Dim>& low, const Vec<Dim>& high, F&& f) const {
        any(low, high, [&](int item) {
            f(item);
            return false;
        });
    }

    /// f(item) for everything that may lie within `radius` of x.
    template <class F>
    void forEachNear(const Vec<Dim>& x, double radius, F&& f) const {
        const Vec<Dim> r = Vec<Dim>::Constant(radius);
        parallelFor(x - r, x + r, f);
    }

private:
    struct Chain {
        int first, last;  // of a bin's entries
    };
    struct Entry {
        int item, next;
    };

    static Vec<Dim> lowest(const Points<Dim>& x) {
        Vec<Dim> corner = x.empty() ? Vec<Dim>(Vec<Dim>::Zero()) : x[0];
        for (const auto& point : x) corner = corner.cwiseMin(point).eval();
        return corner;
    }
    static Vec<Dim> highest(const Points<Dim>& x) {
        Vec<Dim> corner = x.empty() ? Vec<Dim>(Vec<Dim>::Zero()) : x[0];
        for (const auto& point : x) corner = corner.cwiseMax(point).eval();
        return corner;
    }

    int bin(const Vec<Dim>& point, int axis) const {
        const double at = std::floor((point[axis] - low_[axis]) / width_);
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count_[axis] - 1)));
    }

    /// f(chain) for the bins that the box touches, the last axis running fastest, until f gives false. Were all true?
    template <class F>
    bool visit(const Vec<Dim>& low, const Vec<Dim>& high, F&& f) const {
        std::array<int, Dim> first, last, at;
        for (int d = 0; d < Dim; ++d) {
            first[d] = at[d] = bin(low, d);
            last[d] = bin(high, d);
        }
        for (;;) {
            std::size_t index = 0;
            for (int d = 0; d < Dim; ++d) index = index * static_cast<std::size_t>(count_[d]) + at[d];
            if (!f(chain_[index])) return false;
            int d = Dim - 1;
            while (d >= 0 && ++at[d] > last[d]) {
                at[d] = first[d];
                --d;
            }
            if (d < 0) return true;
        }
    }
    template <class F>
    bool visit(const Vec<Dim>& low, const Vec<Dim>& high, F&& f) {
        return std::as_const(*this).visit(low, high, [&](const Chain& chain) { return f(const_cast<Chain&>(chain)); });
    }

    Vec<Dim> low_;
    double width_ = 1;
    std::array<int, Dim> count_{};
    std::vector<Chain> chain_;  // per bin
    std::vector<Entry> entry_;
};

}  // namespace pfem
