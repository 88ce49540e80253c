#include "io/sizesFile.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "dictionary/dictionary.hpp"
#include "io/textHeader.hpp"
#include "io/uniformTime.hpp"

namespace pfem {

namespace {

/// Points as one list of their coordinates.
template <class Points>
std::string listOf(const Points& points) {
    std::string text = "(";
    for (const auto& x : points)
        for (const double c : x) text += fmt::format(" {}", c);
    return text + " )";
}

template <int Dim>
std::string entryOf(const SizePlace<Dim>& place) {
    std::string text = fmt::format("    {{ meshSize {}; distance {};", place.meshSize, place.distance);
    if (place.box) text += " box " + listOf(*place.box) + ";";
    if (!place.patch.empty()) text += fmt::format(" patch \"{}\";", place.patch);
    if (!place.faces.empty()) {
        text += " faces (";
        for (const auto& corners : place.faces) text += " " + listOf(corners);
        text += " );";
    }
    return text + " }\n";
}

double readLength(const Dictionary& dict, const std::string& key) {
    const auto value = dict.get<double>(key);
    if (!(value >= 0) || !std::isfinite(value)) dict.fatal(key, "'" + key + "' is no length");
    return value;
}

template <std::size_t N, int Dim>
std::array<Vec<Dim>, N> toPoints(const Dictionary& dict, const std::string& key, const std::vector<double>& numbers) {
    if (numbers.size() != N * Dim) dict.fatal(key, fmt::format("'{}' must have {} numbers", key, N * Dim));
    std::array<Vec<Dim>, N> points;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (!std::isfinite(numbers[k])) dict.fatal(key, "a number of '" + key + "' is not finite");
        points[k / Dim][static_cast<int>(k % Dim)] = numbers[k];
    }
    return points;
}

template <int Dim>
SizePlace<Dim> readPlace(const Dictionary& dict) {
    SizePlace<Dim> place{readLength(dict, "meshSize"), readLength(dict, "distance")};
    if (dict.found("box")) place.box = toPoints<2, Dim>(dict, "box", dict.get<std::vector<double>>("box"));
    if (dict.found("faces"))
        for (const auto& corners : dict.get<std::vector<std::vector<double>>>("faces"))
            place.faces.push_back(toPoints<Dim, Dim>(dict, "faces", corners));
    place.patch = dict.get("patch", "");
    return place;
}

}  // namespace

template <int Dim>
std::string formatSizes(const PlaceSizes<Dim>& sizes, const std::string& folderName) {
    std::string text = dictionaryHeader("sizes", folderName + "/uniform");
    text += fmt::format("coarsest        {};\nplaces\n(\n", sizes.coarsest);
    for (const auto& place : sizes.places) text += entryOf(place);
    return text + ");\n\n" + dictionaryEndLine();
}

template <int Dim>
PlaceSizes<Dim> readSizes(const std::filesystem::path& folder, const std::string& checksum) {
    const auto file = folder / "uniform" / "sizes";
    const Dictionary dict = Dictionary::read(file);
    if (checksum != "none" && checksumOf(readText(file)) != checksum)
        throw UserError("corrupt, it does not fit entry 'checksums' in uniform/time", {file.string(), 0});
    PlaceSizes<Dim> sizes{readLength(dict, "coarsest")};
    for (const auto& place : dict.dictList("places")) sizes.places.push_back(readPlace<Dim>(place));
    return sizes;
}

#define PFEM_INSTANTIATE(D)                                                        \
    template std::string formatSizes<D>(const PlaceSizes<D>&, const std::string&); \
    template PlaceSizes<D> readSizes<D>(const std::filesystem::path&, const std::string&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
