#pragma once
// What ParaView opens: case.pvd and the .vtu.series files at the root of the case.

#include <filesystem>

namespace pfem {

/// Rewrite case.pvd (parts 0 fluid, 1 solid, 2 boundary) and {fluid,solid,boundary}.vtu.series for the
/// complete time folders that `root` holds now. Each file is replaced at once, so that a running or killed
/// case opens. Throws UserError.
void writeSeries(const std::filesystem::path& root);

}  // namespace pfem
