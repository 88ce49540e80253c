#pragma once
// Tables of postProcessing/ over all restarts, as curves.

#include <filesystem>
#include <string>
#include <vector>

#include "study/curve.hpp"

namespace pfem {

/// One number of a table over time: "D_x", "1_p" (second probe), "volume".
struct ProbeHistory {
    std::string name;
    Curve curve;
};

/// All columns of postProcessing/<function>/*/<file> behind the time, in the order of the table. Each start
/// time has a folder; a later one takes over where it starts. Columns of probes are called
/// <field>_<component>, with the number of the probe in front where there are several; others by the title in
/// the last comment. -1e+300 (a dry probe) is a missing sample. Throws UserError for a table without rows,
/// and for what is not a number with file and line.
std::vector<ProbeHistory> readHistories(const std::filesystem::path& root, const std::string& function,
                                        const std::string& file);

/// The table files that a function has written, ascending. Throws UserError when there is none.
std::vector<std::string> historyFiles(const std::filesystem::path& root, const std::string& function);

}  // namespace pfem
