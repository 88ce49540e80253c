#pragma once
// What ParaView opens: case.pvd and the .vtu.series files at the root of the case.

#include <filesystem>
#include <optional>
#include <vector>

#include "case/timeFolders.hpp"
#include "io/growingFile.hpp"

namespace pfem {

/// The lists of a run that writes time folders, one after the other. A folder that comes last costs the same however
/// many there are; what the root holds is looked through only at first, when somebody else has changed it, and when as
/// many folders again have been added.
class Series {
public:
    explicit Series(std::filesystem::path root);

    /// Before a time folder is written: has anybody else changed the root since the last call of write() or add()?
    void look();

    /// The time folder `name` has been written since look(), and no other change was made. Throws UserError.
    void add(const std::string& name);

    /// All lists anew, for the complete time folders that the root holds now. Throws UserError.
    void write();

private:
    bool append(const TimeFolder& time);
    bool holds(const TimeFolder& time) const;

    std::filesystem::path root_;
    GrowingFile collection_, fluid_, solid_, boundary_;
    std::vector<TimeFolder> times_;                               // in the lists
    std::size_t added_ = 0;                                       // of them since the root was looked through
    std::optional<std::filesystem::file_time_type> rootChanged_;  // null: nothing is known of it
};

/// Rewrite case.pvd (parts 0 fluid, 1 solid, 2 boundary) and {fluid,solid,boundary}.vtu.series for the
/// complete time folders that `root` holds now. Each file is replaced at once, so that a running or killed
/// case opens. Throws UserError.
void writeSeries(const std::filesystem::path& root);

}  // namespace pfem
