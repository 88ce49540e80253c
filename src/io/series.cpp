#include "io/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace pfem {

namespace fs = std::filesystem;

namespace {

const std::array<std::string, 3> parts{"fluid", "solid", "boundary"};

constexpr const char* collectionStart =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "  <Collection>\n";
constexpr const char* collectionEnd = "  </Collection>\n</VTKFile>\n";
constexpr const char* seriesStart = "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [";
constexpr const char* seriesEnd = "\n  ]\n}\n";

/// What case.pvd says of a time.
std::string collectionEntry(const TimeFolder& time) {
    std::string text;
    for (std::size_t part = 0; part < parts.size(); ++part)
        text +=
            fmt::format("    <DataSet timestep=\"{0}\" group=\"\" part=\"{1}\" name=\"{2}\" file=\"{0}/{2}.vtu\"/>\n",
                        time.name, part, parts[part]);
    return text;
}

/// What the list of a part says of a time, with what parts it from the one before.
std::string seriesEntry(const TimeFolder& time, const std::string& part, bool first) {
    return fmt::format("{}    {{ \"name\" : \"{}/{}.vtu\", \"time\" : {} }}", first ? "\n" : ",\n", time.name, part,
                       time.value);
}

std::string seriesText(const std::vector<TimeFolder>& times, const std::string& part) {
    std::string text = seriesStart;
    for (const auto& time : times) text += seriesEntry(time, part, &time == &times.front());
    return text;
}

std::optional<fs::file_time_type> changeOf(const fs::path& folder) {
    std::error_code error;
    const auto time = fs::last_write_time(folder, error);
    return error ? std::nullopt : std::optional(time);
}

fs::path fileOf(const fs::path& root, std::size_t part) { return root / (parts[part] + ".vtu.series"); }

}  // namespace

Series::Series(fs::path root)
    : root_(std::move(root)),
      collection_(root_ / "case.pvd", collectionEnd),
      fluid_(fileOf(root_, 0), seriesEnd),
      solid_(fileOf(root_, 1), seriesEnd),
      boundary_(fileOf(root_, 2), seriesEnd) {}

void Series::look() {
    if (rootChanged_ != changeOf(root_)) rootChanged_.reset();
}

void Series::write() {
    rootChanged_.reset();
    times_ = listTimes(root_).complete;
    added_ = 0;
    std::string text = collectionStart;
    for (const auto& time : times_) text += collectionEntry(time);
    collection_.write(text);
    fluid_.write(seriesText(times_, parts[0]));
    solid_.write(seriesText(times_, parts[1]));
    boundary_.write(seriesText(times_, parts[2]));
    rootChanged_ = changeOf(root_);
}

/// False when a list is not what was left here.
bool Series::append(const TimeFolder& time) {
    const bool first = times_.empty();
    return collection_.append(collectionEntry(time)) && fluid_.append(seriesEntry(time, parts[0], first)) &&
           solid_.append(seriesEntry(time, parts[1], first)) && boundary_.append(seriesEntry(time, parts[2], first));
}

/// A folder of this name is listed, and the lists are what was left here: a run that is done again replaces its
/// folders.
bool Series::holds(const TimeFolder& time) const {
    const auto at = std::lower_bound(times_.begin(), times_.end(), time.value,
                                     [](const TimeFolder& other, double value) { return other.value < value; });
    return at != times_.end() && at->name == time.name && collection_.isLeft() && fluid_.isLeft() && solid_.isLeft() &&
           boundary_.isLeft();
}

void Series::add(const std::string& name) {
    constexpr std::size_t few = 100;
    const TimeFolder time{name, asNumber(name).value_or(0)};
    if (rootChanged_ && holds(time)) {
        rootChanged_ = changeOf(root_);
        return;
    }
    const bool last = times_.empty() || times_.back().value < time.value;
    const bool known = rootChanged_.has_value() && last && added_ < std::max(few, times_.size() / 2);
    rootChanged_.reset();  // until all is written
    if (!known || !append(time)) return write();
    times_.push_back(time);
    ++added_;
    rootChanged_ = changeOf(root_);
}

void writeSeries(const fs::path& root) { Series(root).write(); }

}  // namespace pfem
