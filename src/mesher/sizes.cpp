#include "mesher/sizes.hpp"

#include <fmt/format.h>

namespace pfem {

double readSize(const Dictionary& dict) {
    if (!dict.found("meshSize")) return 0;
    const auto h = dict.get<double>("meshSize");
    if (!(h > 0)) dict.fatal("meshSize", fmt::format("meshSize must be positive, not {:g}", h));
    return h;
}

}  // namespace pfem
