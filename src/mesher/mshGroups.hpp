#pragma once
// The physical groups of a .msh file, and which of them an entity of its geometry belongs to. Internal to src/mesher.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesher/mshLines.hpp"

namespace pfem {

class MshGroups {
public:
    /// Each reads what follows the head of its section. $Entities and $PartitionedEntities are sections of 4.1.
    void readNames(MshLines& lines);
    void readEntities(MshLines& lines);
    /// `gmsh -part n` divides each entity into one per part, and the elements are of those.
    void readPartitionedEntities(MshLines& lines);

    /// Tags of the groups of an entity.
    const std::vector<long>& of(int dimension, long entity) const;

    /// The group's name; its number where it has none.
    std::string name(int dimension, long tag) const;

private:
    std::map<std::pair<int, long>, std::string> names_;
    std::map<std::pair<int, long>, std::vector<long>> ofEntity_;
};

}  // namespace pfem
