#include "base/atomicFile.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/error.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& reason) {
    throw UserError(what + " \"" + path.string() + "\": " + reason, {path.string(), 0});
}

std::string systemReason() { return std::strerror(errno); }

/// Swap two names in one instant where the file system can, otherwise in two.
void exchange(const fs::path& fresh, const fs::path& old) {
    if (renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0) return;
    const fs::path aside = fresh.string() + ".old";
    fs::remove_all(aside);
    fs::rename(old, aside);
    fs::rename(fresh, old);
    fs::rename(aside, fresh);
}

fs::path parentOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

}  // namespace

void flushToDisk(const fs::path& fileOrFolder) {
    const int descriptor = open(fileOrFolder.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail("cannot open", fileOrFolder, systemReason());
    const int result = fsync(descriptor);
    const std::string reason = systemReason();
    const bool unsupported = result != 0 && errno == EINVAL;  // some file systems cannot flush folders
    close(descriptor);
    if (result != 0 && !unsupported) fail("cannot write", fileOrFolder, reason);
}

void writeAtomically(const fs::path& name, const std::string& content) {
    std::error_code unknown;
    fs::path file = name;
    if (fs::is_symlink(name, unknown)) file = fs::weakly_canonical(name, unknown);  // the link stays
    if (unknown) file = name;
    if (const auto status = fs::status(file, unknown); fs::exists(status) && fs::is_other(status)) {
        errno = 0;
        std::ofstream device(file, std::ios::binary);  // /dev/stdout, a pipe: nothing to be replaced
        device << content << std::flush;
        if (!device) fail("cannot write", file, errno != 0 ? systemReason() : "write error");
        return;
    }
    const fs::path staging = parentOf(file) / ("." + file.filename().string() + ".tmp");
    errno = 0;
    std::ofstream stream(staging, std::ios::binary);
    stream << content;
    stream.close();
    if (!stream) {
        const std::string reason = errno != 0 ? systemReason() : "write error";
        std::error_code ignored;
        fs::remove(staging, ignored);
        fail("cannot write", file, reason);
    }
    flushToDisk(staging);
    std::error_code error;
    fs::rename(staging, file, error);
    if (error) {
        std::error_code ignored;
        fs::remove(staging, ignored);
        fail("cannot write", file, error.message());
    }
}

std::string readText(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) throw UserError("cannot find file \"" + file.string() + "\"", {file.string(), 0});
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (stream && fs::file_size(file, ignored) > 0) text << stream.rdbuf();
    if (!stream || !text) fail("cannot read", file, errno != 0 ? systemReason() : "read error");
    return text.str();
}

StagedFolder::StagedFolder(const fs::path& target)
    : target_(target.has_filename() ? target : target.parent_path()),
      staging_(parentOf(target_) / ("." + target_.filename().string() + ".tmp")) {
    std::error_code error;
    fs::remove_all(staging_, error);
    fs::create_directory(staging_, error);  // a case that has been deleted is not made anew
    if (error) fail("cannot make the folder", target_, error.message());
}

StagedFolder::~StagedFolder() {
    if (committed_) return;
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
}

void StagedFolder::commit() {
    try {
        for (const auto& entry : fs::recursive_directory_iterator(staging_)) flushToDisk(entry.path());
        flushToDisk(staging_);
        if (fs::exists(target_) && !fs::is_directory(target_))
            fs::rename(target_, target_.string() + ".old");  // somebody's own file is not ours to remove
        if (fs::exists(target_)) {
            exchange(staging_, target_);
            fs::remove_all(staging_);
        } else {
            fs::rename(staging_, target_);
        }
        committed_ = true;
        flushToDisk(parentOf(target_));
    } catch (const fs::filesystem_error& error) {
        fail("cannot write the folder", target_, error.code().message());
    }
}

}  // namespace pfem
