#pragma once
// A text file to which entries are added before its last lines, whole under its name at any instant, and at a cost that
// does not grow with what it holds.

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace pfem {

/// The text exists twice: under its name, and hidden (.<name>.twin) without the latest entry. To add an entry, the twin
/// gets both, goes to the disk and changes names with the other one. Whoever opens the name sees the old text or the
/// new one.
class GrowingFile {
public:
    /// `end`: the last lines. Nothing is written yet.
    GrowingFile(std::filesystem::path name, std::string end);
    /// The twin goes.
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    /// Replace the file by `text` and the last lines. Throws UserError, as writeAtomically() does.
    void write(const std::string& text);

    /// Is the file the one that was left here?
    bool isLeft() const;

    /// Add `entry` before the last lines. Returns false, and has done nothing, when the file is not the one that was
    /// left here (somebody has replaced or changed it, it is a link, nothing was written). Throws UserError; the file
    /// is whole then, too.
    bool append(const std::string& entry);

private:
    /// A file as it was left.
    struct Stamp {
        dev_t device;
        ino_t number;
        off_t size;
        timespec changed;
        bool operator==(const Stamp& other) const;
    };
    static std::optional<Stamp> stampOf(const std::filesystem::path& file);
    void makeTwin();
    void removeTwin();

    std::filesystem::path name_, twin_;
    std::string end_;
    std::string lacking_;                   // what the twin has not got yet
    std::optional<Stamp> left_, twinLeft_;  // null: not written here
};

}  // namespace pfem
