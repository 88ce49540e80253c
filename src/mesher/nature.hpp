#pragma once
// What a body is, whatever gives its shape.

#include <functional>
#include <string>
#include <vector>

#include "base/types.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

enum class BodyType { fluid, solid };

template <int Dim>
struct Nature {
    Vec<Dim> velocityAt(const Vec<Dim>& x) const { return velocityField ? velocityField(x) : velocity; }

    BodyType type = BodyType::fluid;
    std::string material;
    Vec<Dim> velocity = Vec<Dim>::Zero();                    // initial [m/s]
    std::function<Vec<Dim>(const Vec<Dim>&)> velocityField;  // initial, of the place; empty: uniform
};

/// A point of so many coordinates of the entry `key`; in the plane (x y), or (x y 0).
template <int Dim>
Vec<Dim> toPoint(const Dictionary& dict, const std::string& key, const std::vector<double>& c);

/// type, material (one of `materials`) and velocity: uniform, or by the place: velocity expression ("-2*y" "2*x");
template <int Dim>
void readNature(const Dictionary& dict, const std::vector<std::string>& materials, Nature<Dim>& body);

}  // namespace pfem
