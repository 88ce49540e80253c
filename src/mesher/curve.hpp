#pragma once
// A straight edge or a circular arc, parametrised by its relative length s in [0, 1].

#include <optional>

#include "base/types.hpp"

namespace pfem {

class Curve {
public:
    static Curve line(const Vec<2>& a, const Vec<2>& b);

    /// The arc from a over `through` to b; nothing when the three points lie on one line.
    static std::optional<Curve> arc(const Vec<2>& a, const Vec<2>& through, const Vec<2>& b);

    Vec<2> point(double s) const;
    double length() const;  // [m]
    bool isArc() const { return radius_ > 0; }

    /// The s at which the curve passes within `tolerance` [m] of x.
    std::optional<double> parameterOf(const Vec<2>& x, double tolerance) const;

    /// The part from s0 to s1 (s1 < s0: reversed), with its ends placed exactly at `a` and `b`.
    Curve part(double s0, double s1, const Vec<2>& a, const Vec<2>& b) const;

private:
    Vec<2> a_, b_;
    Vec<2> centre_ = Vec<2>::Zero();
    double radius_ = 0;  // 0: straight
    double angle0_ = 0;  // of a, seen from the centre
    double sweep_ = 0;   // signed angle from a to b
};

}  // namespace pfem
