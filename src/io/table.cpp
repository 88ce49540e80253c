#include "io/table.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iostream>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "io/history.hpp"

namespace pfem {

namespace {

/// A probe may be dry at one start and wet at another.
bool sameColumns(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    const auto plain = [](const std::string& line) { return line.substr(0, line.find("  # Not Found")); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](const auto& s, const auto& t) { return plain(s) == plain(t); });
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const auto& line : lines) text += line + "\n";
    return text;
}

/// Device and number of the file that has this name; zeros when there is none.
std::pair<std::uint64_t, std::uint64_t> identityOf(const std::filesystem::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) return {};
    return {status.st_dev, status.st_ino};
}

constexpr int ownFolders = 3;  // postProcessing/<function>/<startTime>: more than these are never made

}  // namespace

Table::Table(const std::filesystem::path& file, int precision, std::optional<double> resumeAt)
    : file_(file), precision_(precision), resumeAt_(resumeAt) {
    if (!resumeAt_) begin();
}

void Table::makeFolder() const {
    std::error_code error;
    std::filesystem::path base = file_.parent_path();
    for (int n = 0; n < ownFolders; ++n) base = base.parent_path();
    if (!base.empty() && !std::filesystem::exists(base, error))
        error = std::make_error_code(
            std::errc::no_such_file_or_directory);  // a case that has been deleted is not made anew
    else if (file_.has_parent_path())
        std::filesystem::create_directories(file_.parent_path(), error);
    if (error)
        throw UserError("cannot make the folder \"" + file_.parent_path().string() + "\": " + error.message(),
                        {file_.string(), 0});
}

void Table::begin() {
    std::string text = joined(head_);
    if (resumeAt_) {
        const auto previous = previousTable(file_);
        if (previous)
            if (const TableText old = upTo(*resumeAt_, readTable(*previous)); sameColumns(old.head, head_)) {
                file_ = *previous;
                text = joined(old.head) + joined(old.rows);
            }
    }
    makeFolder();
    if (resumeAt_) writeAtomically(file_, text);
    open(resumeAt_ ? std::ios::app : std::ios::trunc);
    resumeAt_.reset();
}

void Table::open(std::ios::openmode mode) {
    errno = 0;
    stream_.close();
    stream_.clear();
    stream_.open(file_, mode);
    if (!stream_)
        throw UserError("cannot write \"" + file_.string() + "\": " + std::strerror(errno), {file_.string(), 0});
    identity_ = identityOf(file_);
}

/// Open the file of this name again when it is another one now (saved by an editor, copied back) or is gone.
void Table::followName() {
    const auto now = identityOf(file_);
    if (now == identity_) return;
    const bool gone = now == decltype(now){};
    std::cerr << "--> PFEM Warning : \"" << file_.string() << "\" was " << (gone ? "removed" : "replaced")
              << " while the run writes it: it is " << (gone ? "begun again" : "continued") << " from here on\n";
    if (gone) makeFolder();
    open(std::ios::app);
    if (gone) stream_ << joined(head_);
}

void Table::line(const std::string& text) {
    const bool comment = !text.empty() && text[0] == '#';
    if (comment) head_.push_back(text);
    if (resumeAt_ && comment) return;
    if (resumeAt_) begin();
    followName();
    errno = 0;
    stream_ << text << std::endl;
    if (!stream_)
        throw UserError("cannot write \"" + file_.string() + "\": " + std::strerror(errno), {file_.string(), 0});
}

void Table::comment(const std::string& text) { line("# " + text); }

void Table::header(const std::vector<std::string>& titles) {
    std::string text = "#";
    for (std::size_t i = 0; i < titles.size(); ++i)
        text += i == 0 ? fmt::format("{:>{}}", titles[i], width() - 1) : fmt::format(" {:>{}}", titles[i], width());
    line(text);
}

std::string Table::rowText(const std::vector<std::string>& columns) const {
    std::string text;
    for (std::size_t i = 0; i < columns.size(); ++i)
        text += fmt::format("{}{:>{}}", i == 0 ? "" : " ", columns[i], width());
    return text;
}

void Table::row(const std::vector<std::string>& columns) { line(rowText(columns)); }

void Table::replaceRows(const std::vector<std::vector<std::string>>& rows) {
    makeFolder();
    std::string text = joined(head_);
    for (const auto& row : rows) text += rowText(row) + "\n";
    stream_.close();
    writeAtomically(file_, text);
    resumeAt_.reset();
    open(std::ios::app);
}

std::string Table::number(double value) const { return fmt::format("{:.{}g}", value, precision_); }

std::string Table::time(double value) const { return timeText(value, precision_); }

std::string Table::tuple(const std::vector<double>& values) const {
    std::string text = fmt::format("{:>{}}", "(", width());
    for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : " ") + number(values[i]);
    return text + ")";
}

}  // namespace pfem
