#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "mesher/meshFile.hpp"
#include "mesher/mshBinary.hpp"
#include "mesher/mshLines.hpp"

namespace pfem {

namespace {

class MshReader {
public:
    MshReader(MshLines lines, std::string file) : lines_(std::move(lines)) { mesh_.file = std::move(file); }

    ForeignMesh read() {
        std::set<std::string> seen;
        while (lines_.next()) {
            if (lines_.word(0).front() != '$') lines_.fail(fmt::format("a section like $Nodes expected, '{}' found", lines_.word(0)));
            const std::string section(lines_.word(0).substr(1));
            if (section != "MeshFormat" && !seen.count("MeshFormat")) lines_.fail("it does not begin with $MeshFormat");
            if (!seen.insert(section).second && section != "Comments") lines_.fail("a second $" + section);
            if (section == "MeshFormat") readFormat();
            else if (section == "PhysicalNames") readNames();
            else if (section == "Entities" && new_) readEntities();
            else if (section == "Nodes") new_ ? readNodes4() : readNodes2();
            else if (section == "Elements") new_ ? readElements4() : readElements2();
            skipTo("$End" + section);
        }
        for (const char* section : {"Nodes", "Elements"})
            if (!seen.count(section)) lines_.fail(fmt::format("there is no ${}", section));
        return std::move(mesh_);
    }

private:
    void skipTo(const std::string& end) {
        while (lines_.next())
            if (lines_.word(0) == end) return;
        lines_.fail("the file ends without " + end);
    }

    void readFormat() {
        lines_.demand("MeshFormat", 3);
        const auto version = lines_.word(0);
        if (version != "2.2" && version != "4.1")
            lines_.fail(fmt::format("its format is {}: save it as 2.2 or 4.1 (gmsh -format msh41)", version));
        if (lines_.whole(1) != 0) lines_.fail("it is binary: save it as text (Mesh.Binary = 0)");
        new_ = version == "4.1";
    }

    void readNames() {
        lines_.demand("PhysicalNames", 1);
        for (long n = lines_.count(0); n > 0; --n) {
            lines_.demand("PhysicalNames", 3);
            const auto begin = lines_.text().find('"'), end = lines_.text().rfind('"');
            if (begin == std::string::npos || end <= begin) lines_.fail("a name in quotes expected");
            names_[{static_cast<int>(lines_.whole(0)), lines_.whole(1)}] = lines_.text().substr(begin + 1, end - begin - 1);
        }
    }

    /// 4.1: the physical groups of points (skipped), curves and surfaces.
    void readEntities() {
        lines_.demand("Entities", 4);
        const std::array<long, 3> counts = {lines_.count(0), lines_.count(1), lines_.count(2)};
        if (lines_.count(3) > 0) lines_.fail("it has volumes: a mesh of the plane is needed");
        for (int dimension = 0; dimension < 3; ++dimension)
            for (long n = counts[dimension]; n > 0; --n) {
                const std::size_t at = dimension == 0 ? 4 : 7;
                lines_.demand("Entities", at + 1);
                const long groups = lines_.count(at);
                lines_.need(at + 1 + static_cast<std::size_t>(groups));
                for (long k = 0; k < groups; ++k)
                    entityGroups_[{dimension, lines_.whole(0)}].push_back(std::abs(lines_.whole(at + 1 + static_cast<std::size_t>(k))));
            }
    }

    void addNode(long tag, std::size_t first) {
        if (lines_.real(first + 2) != 0) lines_.fail("the node leaves the plane z = 0");
        if (!index_.emplace(tag, static_cast<int>(mesh_.x.size())).second) lines_.fail(fmt::format("a second node {}", tag));
        mesh_.x.push_back({lines_.real(first), lines_.real(first + 1)});
    }

    void readNodes2() {
        lines_.demand("Nodes", 1);
        for (long n = lines_.count(0); n > 0; --n) {
            lines_.demand("Nodes", 4);
            addNode(lines_.whole(0), 1);
        }
    }

    void readNodes4() {
        lines_.demand("Nodes", 4);
        for (long blocks = lines_.count(0); blocks > 0; --blocks) {
            lines_.demand("Nodes", 4);
            std::vector<long> tags;
            const long n = lines_.count(3);
            for (long k = 0; k < n; ++k) {
                lines_.demand("Nodes", 1);
                tags.push_back(lines_.whole(0));
            }
            for (const long tag : tags) {
                lines_.demand("Nodes", 3);
                addNode(tag, 0);
            }
        }
    }

    void readElements2() {
        lines_.demand("Elements", 1);
        for (long n = lines_.count(0); n > 0; --n) {
            lines_.demand("Elements", 3);
            const long tags = lines_.count(2);
            lines_.need(3 + static_cast<std::size_t>(tags));
            const long physical = tags > 0 ? lines_.whole(3) : 0;
            addElement(lines_.whole(1), 3 + static_cast<std::size_t>(tags), physical == 0 ? std::vector<long>{} : std::vector<long>{physical});
        }
    }

    void readElements4() {
        lines_.demand("Elements", 4);
        for (long blocks = lines_.count(0); blocks > 0; --blocks) {
            lines_.demand("Elements", 4);
            const int dimension = static_cast<int>(lines_.whole(0));
            const long entity = lines_.whole(1), type = lines_.whole(2);
            const auto& groups = entityGroups_[{dimension, entity}];
            for (long n = lines_.count(3); n > 0; --n) {
                lines_.demand("Elements", 2);
                addElement(type, 1, groups);
            }
        }
    }

    /// Once for each of its groups.
    void addElement(long type, std::size_t first, const std::vector<long>& groups) {
        if (type == 15) return;  // a point
        if (type == 8 || type == 9) lines_.fail("elements of second order: mesh with order 1");
        if (type == 3) lines_.fail("a quadrangle: mesh with triangles");
        if (type != 1 && type != 2) lines_.fail(fmt::format("Gmsh's element type {}: only lines (1) and triangles (2) are possible", type));
        lines_.need(first + (type == 1 ? 2 : 3));
        if (groups.empty()) add(type, first, -1);
        for (const long tag : groups) add(type, first, groupOf(static_cast<int>(type), tag));
    }

    void add(long type, std::size_t first, int group) {
        if (type == 1)
            mesh_.edges.push_back({{node(first), node(first + 1)}, group, lines_.number()});
        else
            mesh_.triangles.push_back({{node(first), node(first + 1), node(first + 2)}, group, lines_.number()});
    }

    int node(std::size_t i) const {
        const auto found = index_.find(lines_.whole(i));
        if (found == index_.end()) lines_.fail(fmt::format("there is no node {}", lines_.whole(i)));
        return found->second;
    }

    int groupOf(int dimension, long tag) {
        const auto named = names_.find({dimension, tag});
        const std::string name = named != names_.end() ? named->second : std::to_string(tag);
        if (const int known = mesh_.groupNamed(dimension, name); known >= 0) return known;
        mesh_.groups.push_back({dimension, name});
        return static_cast<int>(mesh_.groups.size()) - 1;
    }

    MshLines lines_;
    bool new_ = false;  // 4.1
    std::map<std::pair<int, long>, std::string> names_;
    std::map<std::pair<int, long>, std::vector<long>> entityGroups_;
    std::map<long, int> index_;  // node tag -> index
    ForeignMesh mesh_;
};

}  // namespace

ForeignMesh readMsh(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::ifstream stream(file, std::ios::binary);
    std::string content(std::istreambuf_iterator<char>(stream), {});
    if (!stream.is_open() || stream.bad()) throw UserError("cannot read file \"" + name + "\"", {name, 0});
    const bool binary = isBinaryMsh(content);
    if (binary) content = textOfBinaryMsh(content, name);
    return MshReader(MshLines(std::move(content), name, !binary), name).read();
}

}  // namespace pfem
