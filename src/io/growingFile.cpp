#include "io/growingFile.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/atomicFile.hpp"
#include "base/error.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

/// Overwrite a file from `offset` on and bring it to the disk. Returns 0 or the system's error.
int overwrite(const fs::path& file, off_t offset, const std::string& text) {
    const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    int error = 0;
    for (std::size_t done = 0; done < text.size() && error == 0;) {
        const ssize_t n = pwrite(descriptor, text.data() + done, text.size() - done, offset + static_cast<off_t>(done));
        if (n > 0) done += static_cast<std::size_t>(n);
        if (n < 0 && errno != EINTR) error = errno;
    }
    if (error == 0 && fsync(descriptor) != 0) error = errno;
    if (close(descriptor) != 0 && error == 0) error = errno;
    return error;
}

}  // namespace

bool GrowingFile::Stamp::operator==(const Stamp& other) const {
    return device == other.device && number == other.number && size == other.size &&
           changed.tv_sec == other.changed.tv_sec && changed.tv_nsec == other.changed.tv_nsec;
}

std::optional<GrowingFile::Stamp> GrowingFile::stampOf(const fs::path& file) {
    struct stat found;
    if (lstat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return {};
    return Stamp{found.st_dev, found.st_ino, found.st_size, found.st_mtim};
}

GrowingFile::GrowingFile(fs::path name, std::string end)
    : name_(std::move(name)),
      twin_(name_.parent_path() / ("." + name_.filename().string() + ".twin")),
      end_(std::move(end)) {}

GrowingFile::~GrowingFile() {
    if (twinLeft_) removeTwin();
}

void GrowingFile::removeTwin() {
    std::error_code ignored;
    fs::remove(twin_, ignored);
    twinLeft_.reset();
}

void GrowingFile::makeTwin() {
    removeTwin();
    std::error_code error;
    fs::copy_file(name_, twin_, error);
    if (error) {
        removeTwin();
        throw UserError("cannot write \"" + name_.string() + "\": " + error.message(), {name_.string(), 0});
    }
    lacking_.clear();
    twinLeft_ = stampOf(twin_);
}

void GrowingFile::write(const std::string& text) {
    removeTwin();  // also that of a run that was killed
    left_.reset();
    writeAtomically(name_, text + end_);
    left_ = stampOf(name_);
}

bool GrowingFile::isLeft() const { return left_ && stampOf(name_) == left_; }

bool GrowingFile::append(const std::string& entry) {
    if (!isLeft()) return false;
    if (!twinLeft_ || stampOf(twin_) != twinLeft_) makeTwin();
    const auto size = static_cast<off_t>(end_.size());
    if (const int error = overwrite(twin_, twinLeft_->size - size, lacking_ + entry + end_); error != 0) {
        removeTwin();
        throw UserError("cannot write \"" + name_.string() + "\": " + std::strerror(error), {name_.string(), 0});
    }
    const auto written = stampOf(twin_);
    if (renameat2(AT_FDCWD, twin_.c_str(), AT_FDCWD, name_.c_str(), RENAME_EXCHANGE) == 0) {
        twinLeft_ = left_;
        lacking_ = entry;
    } else {  // a file system that cannot: the next entry costs a copy
        std::error_code error;
        fs::rename(twin_, name_, error);
        twinLeft_.reset();
        if (error) {
            removeTwin();
            throw UserError("cannot write \"" + name_.string() + "\": " + error.message(), {name_.string(), 0});
        }
    }
    left_ = written;
    return true;
}

}  // namespace pfem
