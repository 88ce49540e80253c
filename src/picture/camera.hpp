#pragma once
// From where a picture in space is seen.

#include <string>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// What is seen of a case in space, by its user.
struct View {
    Vec<3> direction{0.5, -1, 0.45};  // from what is seen to the eye
    Vec<3> up{0, 0, 1};
    double angle = 0;  // from the upper to the lower end of what is seen [degrees]; 0: parallel rays
};

/// The axis that points most against gravity; z without any.
Vec<3> upwards(const Vec<3>& gravity);

/// Words for directions to the eye, for a case with this axis upwards: front, back, left, right, top, bottom, iso.
/// With z upwards the front is at the end of -y, with y upwards at that of z.
const std::vector<std::string>& viewWords();
Vec<3> viewDirection(const std::string& word, const Vec<3>& up);

/// From the front, a little from the right and from above.
Vec<3> usualDirection(const Vec<3>& up);

/// A point as the camera has it: metres to the right and upwards, at the scale of the centre's distance; distance from
/// the eye along the axis [m]; the scale there, 1 at the centre. What is linear in space is, times `scale`, linear in
/// the picture.
struct Seen {
    Vec<2> place;
    double depth, scale;
};

class Camera {
public:
    /// `radius`: of a sphere that holds all.
    Camera(const View& view, const Vec<3>& centre, double radius);

    Seen see(const Vec<3>& x) const;

    /// A direction in the camera's axes: right, up, to the eye.
    Vec<3> turn(const Vec<3>& direction) const { return axes_ * direction; }

    /// Does a face at x with this normal show its outer side?
    bool shows(const Vec<3>& x, const Vec<3>& normal) const;

private:
    Tensor<3> axes_;  // rows
    Vec<3> centre_;
    double distance_;  // of the eye from the centre
    bool perspective_;
};

}  // namespace pfem
