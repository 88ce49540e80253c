#include "case/timeFolders.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace pfem {

namespace fs = std::filesystem;

namespace {

/// What is missing in a time folder or cannot be reached, or "".
std::string incomplete(const fs::path& folder) {
    for (const char* file : {"uniform/time", "fluid.vtu", "solid.vtu", "boundary.vtu"}) {
        std::error_code error;
        if (fs::is_regular_file(folder / file, error)) continue;
        return std::string(file) + (error == std::errc::permission_denied ? " may not be read" : " is missing");
    }
    return "";
}

}  // namespace

std::optional<double> asNumber(const std::string& text) {
    if (text.empty() || (text[0] != '-' && text[0] != '.' && (text[0] < '0' || text[0] > '9'))) return {};
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() + text.size() || !std::isfinite(value)) return {};
    if (text.find_first_of("xX") != std::string::npos) return {};  // 0x10 is not a time
    return value;
}

TimeFolders listTimes(const fs::path& root) {
    TimeFolders found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(root, error)) {
        const std::string name = entry.path().filename().string();
        const auto value = asNumber(name);
        std::error_code ignored;
        if (!value || !entry.is_directory(ignored)) continue;
        const std::string reason = incomplete(entry.path());
        if (reason.empty())
            found.complete.push_back({name, *value});
        else
            found.ignored.push_back({name, reason});
    }
    std::sort(found.complete.begin(), found.complete.end(), [](const TimeFolder& a, const TimeFolder& b) {
        return a.value != b.value ? a.value < b.value : a.name < b.name;
    });
    std::sort(found.ignored.begin(), found.ignored.end(),
              [](const IgnoredFolder& a, const IgnoredFolder& b) { return *asNumber(a.name) < *asNumber(b.name); });
    return found;
}

void removeTime(const fs::path& root, const std::string& name, std::error_code& error) {
    const fs::path aside = root / ("." + name + ".tmp");
    fs::remove_all(aside, error);
    fs::rename(root / name, aside, error);
    if (!error) fs::remove_all(aside, error);
}

std::string timeName(double value, const std::string& format, int precision) {
    std::ostringstream stream;
    if (format == "fixed") stream.setf(std::ios::fixed, std::ios::floatfield);
    if (format == "scientific") stream.setf(std::ios::scientific, std::ios::floatfield);
    stream.precision(precision);
    stream << (value == 0 ? 0.0 : value);  // never "-0"
    return stream.str();
}

int precisionToDistinguish(double a, double b, const std::string& format, int precision) {
    const auto isRough = [&] {  // a name rounded up by much of the step could overtake the next one
        const std::string name = timeName(b, format, precision);
        return timeName(a, format, precision) == name ||
               std::abs(std::strtod(name.c_str(), nullptr) - b) > std::abs(b - a) / 300;
    };
    while (precision < 17 && a != b && isRough()) ++precision;
    return precision;
}

}  // namespace pfem
