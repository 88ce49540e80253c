#pragma once
// The scalars that a picture can be coloured by.

#include <string>
#include <vector>

#include "functions/fields.hpp"

namespace pfem {

template <int Dim>
struct PictureField {
    std::string name;
    std::string title;                                // with its unit, for the colour bar
    Region region;                                    // where it has a meaning; the rest is drawn in a plain colour
    double (*value)(const Nodes<Dim>& nodes, int i);  // nullptr: nowhere
};

/// p, U (magnitude), Ux, Uy, D, Dx, Dy, vonMises, sigmaxx, ..., none. Throws UserError with the valid list.
template <int Dim>
const PictureField<Dim>& pictureField(const std::string& name);

/// All names, for help texts.
template <int Dim>
std::vector<std::string> pictureFieldNames();

/// Is this kind of body coloured by the field?
template <int Dim>
bool hasValues(const PictureField<Dim>& field, Region body) {
    return field.value && (field.region == Region::both || field.region == body);
}

/// sqrt(3/2 s:s) of the deviator s.
template <int Dim>
double vonMises(const Stress<Dim>& sigma);

}  // namespace pfem
