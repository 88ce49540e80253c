#pragma once
// One .vtu file, with VTK's silent failures turned into errors. Internal to src/io.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>

namespace pfem {

/// Write as appended raw data, compressed by zlib: the same grid gives the same bytes.
/// Throws UserError when the file cannot be written (also when the disk is full).
void writeGrid(const std::filesystem::path& file, vtkUnstructuredGrid* grid);

/// Throws UserError when the file is missing, truncated or not a grid. What a sound grid contains is
/// for the caller to check.
vtkSmartPointer<vtkUnstructuredGrid> readGrid(const std::filesystem::path& file);

/// The same for surfaces (.vtp).
void writePolyData(const std::filesystem::path& file, vtkPolyData* surface);
vtkSmartPointer<vtkPolyData> readPolyData(const std::filesystem::path& file);

}  // namespace pfem
