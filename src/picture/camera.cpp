#include "picture/camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace pfem {

namespace {

constexpr double pi = 3.141592653589793;

Vec<3> rightOf(const Vec<3>& up) { return std::abs(up[0]) > 0.5 ? Vec<3>::UnitY() : Vec<3>::UnitX(); }

Vec<3> frontOf(const Vec<3>& up) { return rightOf(up).cross(up); }

}  // namespace

Vec<3> upwards(const Vec<3>& gravity) {
    Eigen::Index axis = 2;
    if (!(gravity.cwiseAbs().maxCoeff(&axis) > 0)) return Vec<3>::UnitZ();
    return gravity[axis] > 0 ? Vec<3>(-Vec<3>::Unit(axis)) : Vec<3>(Vec<3>::Unit(axis));
}

const std::vector<std::string>& viewWords() {
    static const std::vector<std::string> words{"front", "back", "left", "right", "top", "bottom", "iso"};
    return words;
}

Vec<3> viewDirection(const std::string& word, const Vec<3>& up) {
    const Vec<3> right = rightOf(up), front = frontOf(up);
    const std::vector<Vec<3>> directions{front, -front, -right, right, up, -up, right + front + up};
    const auto found = std::find(viewWords().begin(), viewWords().end(), word);
    if (found == viewWords().end()) throw UserError(notValid(word, "view", viewWords()));
    return directions[static_cast<std::size_t>(found - viewWords().begin())];
}

Vec<3> usualDirection(const Vec<3>& up) { return frontOf(up) + 0.5 * rightOf(up) + 0.45 * up; }

Camera::Camera(const View& view, const Vec<3>& centre, double radius) : centre_(centre), perspective_(view.angle > 0) {
    const Vec<3> back = view.direction.normalized();
    Vec<3> right = view.up.cross(back);
    if (right.norm() < 1e-6) right = rightOf(view.up);  // from above: the front is at the lower end
    right.normalize();
    axes_.row(0) = right;
    axes_.row(1) = back.cross(right);
    axes_.row(2) = back;
    distance_ = perspective_ ? radius / std::sin(0.5 * view.angle * pi / 180) : 2 * radius;
}

Seen Camera::see(const Vec<3>& x) const {
    const Vec<3> y = turn(x - centre_);
    const double depth = distance_ - y[2], scale = perspective_ ? distance_ / depth : 1;
    return {scale * y.head<2>(), depth, scale};
}

bool Camera::shows(const Vec<3>& x, const Vec<3>& normal) const {
    const Vec<3> back = axes_.row(2);
    return (perspective_ ? Vec<3>(centre_ + distance_ * back - x) : back).dot(normal) > 0;
}

}  // namespace pfem
