#pragma once
// A mesh that another program has made: points, cells and faces in groups.

#include <string>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// In the plane triangles and edges, in space tetrahedra and triangles.
template <int Dim>
struct ForeignMeshOf {
    /// A cell or a face with N nodes.
    template <int N>
    struct Element {
        std::array<int, N> nodes;
        int group = -1;  // index into groups; -1: in none
        int line = 0;    // where it stands in the file; 0: not known
    };
    struct Group {
        int dimension;  // 3: of tetrahedra, 2: of triangles, 1: of edges
        std::string name;
    };

    std::string file;
    Points<Dim> x;
    std::vector<Element<Dim + 1>> cells;
    std::vector<Element<Dim>> faces;
    std::vector<Group> groups;
    std::string remark;  // on its groups, for whoever looks for one in vain

    /// Index of the group, -1 where there is none.
    int groupNamed(int dimension, const std::string& name) const {
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (groups[g].dimension == dimension && groups[g].name == name) return static_cast<int>(g);
        return -1;
    }
    std::vector<std::string> groupNames(int dimension) const {
        std::vector<std::string> names;
        for (const auto& group : groups)
            if (group.dimension == dimension) names.push_back(group.name);
        return names;
    }
};

using ForeignMesh = ForeignMeshOf<2>;

}  // namespace pfem
