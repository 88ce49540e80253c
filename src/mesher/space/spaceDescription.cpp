#include "mesher/space/spaceDescription.hpp"

namespace pfem {

Places::Places(const Dictionary& dict) {
    (*this)[""] = dict.where();
    for (const auto& key : dict.keys()) (*this)[key] = dict.where(key);
}

Location Places::of(const std::string& keyword) const {
    auto found = find(keyword);
    if (found == end()) found = find("");
    return found == end() ? Location() : found->second;
}

std::vector<std::string> SpaceDescription::geometryNames() const {
    std::vector<std::string> names;
    for (const auto& geometry : geometries) names.push_back(geometry.name);
    return names;
}

int SpaceDescription::geometryNamed(const std::string& name) const {
    for (std::size_t g = 0; g < geometries.size(); ++g)
        if (geometries[g].name == name) return static_cast<int>(g);
    return -1;
}

}  // namespace pfem
