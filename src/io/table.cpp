#include "io/table.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace pfem {

Table::Table(const std::filesystem::path& file, int precision) : file_(file), precision_(precision) {
    std::error_code error;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
    if (error)
        throw UserError("cannot make the folder \"" + file.parent_path().string() + "\": " + error.message(),
                        {file.string(), 0});
    errno = 0;
    stream_.open(file, std::ios::trunc);
    if (!stream_)
        throw UserError("cannot write \"" + file.string() + "\": " + std::strerror(errno),
                        {file.string(), 0});
}

void Table::line(const std::string& text) {
    errno = 0;
    stream_ << text << std::endl;
    if (!stream_)
        throw UserError("cannot write \"" + file_.string() + "\": " + std::strerror(errno),
                        {file_.string(), 0});
}

void Table::comment(const std::string& text) {
    line("# " + text);
}

void Table::header(const std::vector<std::string>& titles) {
    std::string text = "#";
    for (std::size_t i = 0; i < titles.size(); ++i)
        text += i == 0 ? fmt::format("{:>{}}", titles[i], width() - 1)
                       : fmt::format(" {:>{}}", titles[i], width());
    line(text);
}

void Table::row(const std::vector<std::string>& columns) {
    std::string text;
    for (std::size_t i = 0; i < columns.size(); ++i)
        text += fmt::format("{}{:>{}}", i == 0 ? "" : " ", columns[i], width());
    line(text);
}

std::string Table::number(double value) const {
    return fmt::format("{:.{}g}", value, precision_);
}

std::string Table::tuple(const std::vector<double>& values) const {
    std::string text = fmt::format("{:>{}}", "(", width());
    for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : " ") + number(values[i]);
    return text + ")";
}

}  // namespace pfem
