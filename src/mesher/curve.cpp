#include "mesher/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pfem {

namespace {

constexpr double twoPi = 2 * std::numbers::pi;

double angleOf(const Vec<2>& d) { return std::atan2(d.y(), d.x()); }

/// angle modulo 2 pi, in [0, 2 pi)
double positive(double angle) {
    const double r = std::fmod(angle, twoPi);
    return r < 0 ? r + twoPi : r;
}

}  // namespace

Curve Curve::line(const Vec<2>& a, const Vec<2>& b) {
    Curve c;
    c.a_ = a;
    c.b_ = b;
    return c;
}

std::optional<Curve> Curve::arc(const Vec<2>& a, const Vec<2>& through, const Vec<2>& b) {
    const Vec<2> u = through - a, w = b - a;
    const double cross = u.x() * w.y() - u.y() * w.x();
    if (std::abs(cross) <= 1e-9 * u.norm() * w.norm() || (through - b).norm() <= 1e-9 * w.norm()) return {};
    // circumcentre of (a, through, b), relative to a
    const Vec<2> centre =
        Vec<2>(w.y() * u.squaredNorm() - u.y() * w.squaredNorm(), u.x() * w.squaredNorm() - w.x() * u.squaredNorm()) /
        (2 * cross);
    Curve c = line(a, b);
    c.centre_ = a + centre;
    c.radius_ = centre.norm();
    c.angle0_ = angleOf(a - c.centre_);
    const double end = positive(angleOf(b - c.centre_) - c.angle0_);
    const double middle = positive(angleOf(through - c.centre_) - c.angle0_);
    c.sweep_ = middle < end ? end : end - twoPi;
    return c;
}

Vec<2> Curve::point(double s) const {
    if (s <= 0) return a_;
    if (s >= 1) return b_;
    if (!isArc()) return a_ + s * (b_ - a_);
    const double angle = angle0_ + s * sweep_;
    return centre_ + radius_ * Vec<2>(std::cos(angle), std::sin(angle));
}

double Curve::length() const { return isArc() ? radius_ * std::abs(sweep_) : (b_ - a_).norm(); }

std::optional<double> Curve::parameterOf(const Vec<2>& x, double tolerance) const {
    if ((x - a_).norm() <= tolerance) return 0.0;
    if ((x - b_).norm() <= tolerance) return 1.0;
    double s;
    if (isArc()) {
        const double turn = angleOf(x - centre_) - angle0_;
        s = (sweep_ > 0 ? positive(turn) : positive(-turn)) / std::abs(sweep_);
    } else {
        s = (x - a_).dot(b_ - a_) / (b_ - a_).squaredNorm();
    }
    if (s <= 0 || s >= 1 || (point(s) - x).norm() > tolerance) return {};
    return s;
}

Curve Curve::part(double s0, double s1, const Vec<2>& a, const Vec<2>& b) const {
    Curve c = *this;
    c.a_ = a;
    c.b_ = b;
    c.angle0_ = angle0_ + s0 * sweep_;
    c.sweep_ = (s1 - s0) * sweep_;
    return c;
}

}  // namespace pfem
