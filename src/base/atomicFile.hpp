#pragma once
// Files and folders that are complete or absent, whatever kills the program in between.

#include <filesystem>
#include <string>

namespace pfem {

/// Replace `file` by `content`: written beside it, brought to the disk, renamed.
/// Throws UserError (naming the file and the system's reason) and leaves the old file when that fails. A device or pipe
/// is not replaced but written; of a link, what it stands for.
void writeAtomically(const std::filesystem::path& file, const std::string& content);

/// Bring a file or a folder's list of names to the disk. Throws UserError.
void flushToDisk(const std::filesystem::path& fileOrFolder);

/// The whole text of a file. Throws UserError when it cannot be read.
std::string readText(const std::filesystem::path& file);

/// A folder that is filled under a hidden name (.<name>.tmp) and appears under its own name at once.
/// Without commit() nothing appears: the destructor removes what was written.
class StagedFolder {
public:
    /// Makes the hidden folder, empty. Throws UserError when its parent cannot be written.
    explicit StagedFolder(const std::filesystem::path& target);
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    /// Where to write meanwhile.
    const std::filesystem::path& path() const { return staging_; }

    /// Flush all files and take the target's name; a folder of that name is replaced. Throws UserError.
    void commit();

private:
    std::filesystem::path target_;
    std::filesystem::path staging_;
    bool committed_ = false;
};

}  // namespace pfem
