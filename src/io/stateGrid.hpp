#pragma once
// What the files of a time folder are called and contain; shared by writer and reader. Internal to src/io.

#include <vtkCellType.h>

#include <array>
#include <string>

#include "base/types.hpp"

namespace pfem::stateGrid {

inline const std::string fluidFile = "fluid.vtu";
inline const std::string solidFile = "solid.vtu";
inline const std::string boundaryFile = "boundary.vtu";
inline const std::array<std::string, 3> files{fluidFile, solidFile, boundaryFile};

template <int Dim>
inline constexpr int simplexType = Dim == 2 ? VTK_TRIANGLE : VTK_TETRA;
template <int Dim>
inline constexpr int faceType = Dim == 2 ? VTK_LINE : VTK_TRIANGLE;

/// VTK's order of a symmetric tensor.
inline const std::array<const char*, 6> tensorComponents{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};

/// Cell data `material` of an isolated particle.
inline constexpr int noMaterial = -1;

}  // namespace pfem::stateGrid
