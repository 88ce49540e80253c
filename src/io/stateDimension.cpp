#include "io/stateDimension.hpp"

#include "io/gridFile.hpp"
#include "io/stateGrid.hpp"

namespace pfem {

int stateDimension(const std::filesystem::path& folder) {
    // the walls' file is the smallest; without walls the others say it
    for (const auto& name : {stateGrid::boundaryFile, stateGrid::solidFile, stateGrid::fluidFile}) {
        const auto grid = readGrid(folder / name);
        for (vtkIdType e = 0; e < grid->GetNumberOfCells(); ++e) {
            const int type = grid->GetCellType(e);
            if (type == VTK_TETRA || (type == VTK_TRIANGLE && name == stateGrid::boundaryFile)) return 3;
            if (type == VTK_TRIANGLE || type == VTK_LINE) return 2;
        }
    }
    return 2;
}

}  // namespace pfem
