#include "mesher/sizes.hpp"

#include <fmt/format.h>

namespace pfem {

double readSize(const Dictionary& dict) {
    if (!dict.found("meshSize")) return 0;
    const auto h = dict.get<double>("meshSize");
    if (!(h > 0)) dict.fatal("meshSize", fmt::format("meshSize must be positive, not {:g}", h));
    return h;
}

double readRadius(const Dictionary& dict) {
    const auto radius = dict.get<double>("radius");
    if (!(radius > 0)) dict.fatal("radius", "radius must be positive");
    return radius;
}

bool readHoldSizes(const Dictionary& dict) {
    const bool hold = dict.get("holdSizes", false);
    if (hold && dict.found("meshFile"))
        dict.fatal("holdSizes", "The mesh of a file has sizes of nodes, not of places: holdSizes is for shapes");
    return hold;
}

}  // namespace pfem
