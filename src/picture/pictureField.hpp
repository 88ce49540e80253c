#pragma once
// The scalars that a picture can be coloured by.

#include <string>
#include <vector>

#include "functions/fields.hpp"

namespace pfem {

struct PictureField {
    std::string name;
    std::string title;  // with its unit, for the colour bar
    Region region;      // where it has a meaning; the rest is drawn in a plain colour
    double (*value)(const Nodes<2>& nodes, int i);
};

/// p, U (magnitude), Ux, Uy, D, Dx, Dy, vonMises, sigmaxx, ... Throws UserError with the valid list.
const PictureField& pictureField(const std::string& name);

/// All names, for help texts.
std::vector<std::string> pictureFieldNames();

/// sqrt(3/2 s:s) of the deviator s; components xx yy zz xy.
double vonMises(const Stress<2>& sigma);

}  // namespace pfem
