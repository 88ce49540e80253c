#include "case/runLock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>

#include "base/error.hpp"

namespace pfem {

namespace {

std::string holder(const std::string& program) {
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    std::array<char, 64> date{};
    std::strftime(date.data(), date.size(), "%Y-%m-%d %H:%M:%S", &local);
    return fmt::format("{}, process {} on {}, since {}", program, getpid(), host.data(), date.data());
}

std::string contentOf(int descriptor) {
    std::array<char, 512> text{};
    const ssize_t n = pread(descriptor, text.data(), text.size() - 1, 0);
    std::string content(text.data(), n > 0 ? static_cast<std::size_t>(n) : 0);
    return content.substr(0, content.find('\n'));
}

/// Is the open file still the one that has this name? The holder removes it at its end.
bool isNamed(int descriptor, const std::filesystem::path& file) {
    struct stat opened {
    }, named{};
    return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

[[noreturn]] void held(const std::filesystem::path& file, const std::string& by) {
    throw UserError("Another program is writing this case: " + (by.empty() ? "its .pfemLock was removed" : by) +
                        ".\nWait for it, stop it, or copy the case: two runs in one folder would mix their times",
                    {file.string(), 0});
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& root, const std::string& program) : file_(root / ".pfemLock") {
    for (;;) {
        descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor_ < 0)
            throw UserError("cannot write in the case folder \"" + root.string() + "\": " + std::strerror(errno),
                            {file_.string(), 0});
        if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
            const bool busy = errno == EWOULDBLOCK;
            const std::string reason = std::strerror(errno), by = contentOf(descriptor_);
            close(descriptor_);
            if (!busy) throw UserError("cannot lock the case: " + reason, {file_.string(), 0});
            held(file_, by);
        }
        if (isNamed(descriptor_, file_)) break;
        close(descriptor_);
    }
    folder_ = open(root.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder_ >= 0 && flock(folder_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        const std::string by = contentOf(descriptor_);
        if (by.empty()) unlink(file_.c_str());  // made just now: the other run's was removed
        close(folder_);
        close(descriptor_);
        held(file_, by);
    }
    abandoned_ = contentOf(descriptor_);
    const std::string text = holder(program) + "\n";
    if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, text.data(), text.size(), 0) < 0) {
        const std::string reason = std::strerror(errno);
        if (folder_ >= 0) close(folder_);
        close(descriptor_);
        throw UserError("cannot write \"" + file_.string() + "\": " + reason, {file_.string(), 0});
    }
}

RunLock::~RunLock() {
    if (folder_ >= 0) close(folder_);  // first: nobody who makes a new file then finds it held
    if (isNamed(descriptor_, file_))
        unlink(file_.c_str());  // before the lock goes: who opens it now finds its name gone
    close(descriptor_);
}

}  // namespace pfem
