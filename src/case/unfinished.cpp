#include "case/unfinished.hpp"

#include <algorithm>

#include "case/timeFolders.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

/// The time's name in ".<time><ending>", or "".
std::string timeOf(const std::string& name, const std::string& ending) {
    if (name.size() <= ending.size() + 1 || name[0] != '.' || !name.ends_with(ending)) return "";
    const std::string time = name.substr(1, name.size() - 1 - ending.size());
    return asNumber(time) || time == "failed" ? time : "";
}

}  // namespace

std::vector<std::string> clearUnfinished(const fs::path& root) {
    std::vector<std::string> found, done;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(root, error)) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    for (const auto& name : found) {  // ".0.1.tmp" was written beside "0.1", or its predecessor is in ".0.1.tmp.old"
        const std::string replaced = timeOf(name, ".tmp.old"), time = timeOf(name, ".tmp");
        if (!replaced.empty() && !fs::exists(root / replaced, error)) {
            fs::rename(root / name, root / replaced, error);
            if (!error)
                done.push_back("time folder " + replaced + " is put back: it was being replaced when a run ended");
        } else if (!replaced.empty() || !time.empty()) {
            fs::remove_all(root / name, error);
            done.push_back("the unfinished folder " + name +
                           " is removed: a run ended while it wrote or removed time " +
                           (replaced.empty() ? time : replaced));
        }
    }
    return done;
}

}  // namespace pfem
