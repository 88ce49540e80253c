#pragma once
// One writer for each case: two runs in one folder would mix their times.

#include <filesystem>
#include <string>

namespace pfem {

/// Holds <root>/.pfemLock while it lives. The lock itself is the kernel's (flock), so that it ends with the process
/// however that ends; the file says who holds it. A file that a dead process has left is taken over. The case folder is
/// locked too, where its file system can, so that removing the file does not let a second run in.
class RunLock {
public:
    /// Throws UserError when a living process holds the lock, or the folder cannot be written.
    RunLock(const std::filesystem::path& root, const std::string& program);
    ~RunLock();
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

    /// Who left a lock without ending properly ("pfemFsiFoam, process 17 on host, since ..."), or "".
    const std::string& abandoned() const { return abandoned_; }

private:
    std::filesystem::path file_;
    int descriptor_ = -1, folder_ = -1;
    std::string abandoned_;
};

}  // namespace pfem
