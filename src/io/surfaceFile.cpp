#include "io/surfaceFile.hpp"

#include <algorithm>
#include <cstring>

#include "base/atomicFile.hpp"
#include "io/surfaceLines.hpp"

namespace pfem {

namespace {

int regionOf(TriSurface& surface, const std::string& name) {
    if (const int known = surface.regionNamed(name); known >= 0) return known;
    surface.regions.push_back(name);
    return static_cast<int>(surface.regions.size()) - 1;
}

/// Three points of its own for each triangle.
void addTriangle(TriSurface& surface, const std::array<Vec<3>, 3>& corners, int region) {
    const int n = static_cast<int>(surface.x.size());
    surface.x.insert(surface.x.end(), corners.begin(), corners.end());
    surface.triangles.push_back({n, n + 1, n + 2});
    surface.region.push_back(region);
}

std::string lower(std::string word) {
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    return word;
}

/// A binary STL has as many bytes as its count says; a text begins with "solid" and has "facet" on its next line.
bool isBinaryStl(const std::string& content) {
    if (content.size() < 84) return false;
    std::uint32_t count;
    std::memcpy(&count, content.data() + 80, sizeof count);
    if (content.size() == 84 + 50 * static_cast<std::size_t>(count)) return true;
    return content.compare(0, 5, "solid") != 0 || content.find('\0') < 200;
}

TriSurface binaryStl(const std::string& content, const std::filesystem::path& file) {
    std::uint32_t count;
    std::memcpy(&count, content.data() + 80, sizeof count);
    const auto fail = [&](const std::string& message) {
        throw UserError("cannot read the surface \"" + file.string() + "\": " + message, {file.string(), 0});
    };
    if (content.size() < 84 + 50 * static_cast<std::size_t>(count))
        fail(fmt::format("{} triangles need {} bytes; it has {}", count, 84 + 50 * static_cast<std::size_t>(count),
                         content.size()));
    TriSurface surface;
    const int region = regionOf(surface, file.stem().string());
    for (std::uint32_t k = 0; k < count; ++k) {
        std::array<float, 9> c;  // behind the normal
        std::memcpy(c.data(), content.data() + 84 + 50 * static_cast<std::size_t>(k) + 12, sizeof c);
        std::array<Vec<3>, 3> corners;
        for (int i = 0; i < 9; ++i) {
            if (!std::isfinite(c[i])) fail(fmt::format("triangle {} has a coordinate that is not finite", k));
            corners[i / 3][i % 3] = c[i];
        }
        addTriangle(surface, corners, region);
    }
    return surface;
}

/// Polygon i, j, k, ... as triangles.
void addPolygon(TriSurface& surface, const std::vector<int>& corners, int region) {
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        surface.triangles.push_back({corners[0], corners[k], corners[k + 1]});
        surface.region.push_back(region);
    }
}

}  // namespace

TriSurface readStl(const std::filesystem::path& file) {
    const std::string content = readText(file);
    if (isBinaryStl(content)) return binaryStl(content, file);
    SurfaceLines lines(content, file.string());
    TriSurface surface;
    int region = -1;
    std::vector<Vec<3>> corners;
    while (lines.next()) {
        const std::string word = lower(std::string(lines.words[0]));
        if (word == "solid") {
            std::string name = lines.words.size() > 1 ? std::string(lines.words[1]) : file.stem().string();
            region = regionOf(surface, name);
        } else if (word == "vertex") {
            if (region < 0) lines.fail("a vertex before 'solid'");
            corners.push_back(lines.point(1));
        } else if (word == "endloop") {
            if (corners.size() != 3) lines.fail(fmt::format("a facet with {} vertices", corners.size()));
            addTriangle(surface, {corners[0], corners[1], corners[2]}, region);
            corners.clear();
        } else if (word != "facet" && word != "outer" && word != "endfacet" && word != "endsolid") {
            lines.fail(fmt::format("'{}' is no word of an STL file", lines.words[0]));
        }
    }
    if (!corners.empty()) lines.fail("the file ends within a facet");
    return surface;
}

TriSurface readObj(const std::filesystem::path& file) {
    const std::string content = readText(file);
    SurfaceLines lines(content, file.string());
    TriSurface surface;
    int region = -1;
    while (lines.next()) {
        const auto word = lines.words[0];
        if (word == "v") {
            surface.x.push_back(lines.point(1));
        } else if (word == "g" || word == "o") {
            region = regionOf(surface, lines.words.size() > 1 ? std::string(lines.words[1]) : file.stem().string());
        } else if (word == "f") {
            lines.need(4);
            std::vector<int> corners;
            for (std::size_t k = 1; k < lines.words.size(); ++k) {
                const long i = lines.whole(lines.words[k].substr(0, lines.words[k].find('/')));
                const long n = static_cast<long>(surface.x.size()), at = i < 0 ? n + i : i - 1;
                if (at < 0 || at >= n) lines.fail(fmt::format("there is no vertex {}; there are {}", i, n));
                corners.push_back(static_cast<int>(at));
            }
            if (region < 0) region = regionOf(surface, file.stem().string());
            addPolygon(surface, corners, region);
        }
    }
    return surface;
}

TriSurface readOff(const std::filesystem::path& file) {
    const std::string content = readText(file);
    SurfaceLines lines(content, file.string());
    if (!lines.next() || lines.words[0] != "OFF") lines.fail("its first word is not OFF");
    std::size_t first = 1;
    if (lines.words.size() == 1) {
        if (!lines.next()) lines.fail("the file ends before its counts");
        first = 0;
    }
    lines.need(first + 2);
    const long points = lines.whole(lines.words[first]), faces = lines.whole(lines.words[first + 1]);
    const long most = static_cast<long>(content.size());
    if (points < 0 || faces < 0 || points > most || faces > most) lines.fail("its counts are impossible");
    TriSurface surface;
    const int region = regionOf(surface, file.stem().string());
    for (long k = 0; k < points; ++k) {
        if (!lines.next()) lines.fail(fmt::format("{} points expected, {} found", points, k));
        surface.x.push_back(lines.point(0));
    }
    for (long k = 0; k < faces; ++k) {
        if (!lines.next()) lines.fail(fmt::format("{} faces expected, {} found", faces, k));
        const long n = lines.whole(lines.words[0]);
        if (n < 3 || n > most) lines.fail(fmt::format("a face of {} points", n));
        lines.need(static_cast<std::size_t>(n) + 1);
        std::vector<int> corners;
        for (long c = 1; c <= n; ++c) {
            const long i = lines.whole(lines.words[static_cast<std::size_t>(c)]);
            if (i < 0 || i >= points) lines.fail(fmt::format("there is no point {}; there are {}", i, points));
            corners.push_back(static_cast<int>(i));
        }
        addPolygon(surface, corners, region);
    }
    return surface;
}

TriSurface readSurfaceFile(const std::filesystem::path& file) {
    const std::string ending = lower(file.extension().string());
    const std::vector<std::pair<std::string, TriSurface (*)(const std::filesystem::path&)>> readers = {
        {".stl", readStl}, {".obj", readObj}, {".off", readOff}, {".vtp", readVtp}};
    std::vector<std::string> endings;
    for (const auto& [name, reader] : readers) {
        if (name == ending) {
            TriSurface surface = reader(file);
            if (surface.triangles.empty())
                throw UserError("there is no triangle in \"" + file.string() + "\"", {file.string(), 0});
            return surface;
        }
        endings.push_back(name);
    }
    throw UserError(notValid(ending, "ending of a surface file", endings), {file.string(), 0});
}

}  // namespace pfem
