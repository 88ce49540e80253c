#include "dictionary/files.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

namespace fs = std::filesystem;

namespace pfem {

namespace {

constexpr std::uintmax_t maxFileSize = std::uintmax_t{1} << 28;

std::string environment(const char* name) {
    const char* text = std::getenv(name);
    return text ? text : "";
}

/// <prefix>/bin/program uses <prefix>/share/pfem/etc; a program in a build folder the etc of the source.
std::vector<fs::path> installedEtc() {
    std::vector<fs::path> folders;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) folders.push_back(program.parent_path().parent_path() / "share/pfem/etc");
#ifdef PFEM_INSTALL_ETC
    folders.emplace_back(PFEM_INSTALL_ETC);
#endif
#ifdef PFEM_SOURCE_ETC
    folders.emplace_back(PFEM_SOURCE_ETC);
#endif
    return folders;
}

std::vector<fs::path> etcFolders() {
    std::vector<fs::path> folders;
    if (const auto etc = environment("PFEM_ETC"); !etc.empty()) folders.emplace_back(etc);
    if (const auto home = environment("HOME"); !home.empty()) folders.push_back(fs::path(home) / ".pfem");
    for (auto& folder : installedEtc()) folders.push_back(std::move(folder));
    return folders;
}

}  // namespace

std::size_t byteOrderMark(const std::string& text) { return text.starts_with("\xEF\xBB\xBF") ? 3 : 0; }

std::string fileText(const fs::path& file, const Location& where) {
    const Location place = where.file.empty() ? Location{file.string(), 0} : where;
    std::error_code error;
    const auto status = fs::status(file, error);
    if (error || !fs::exists(status)) throw UserError("cannot find file \"" + file.string() + '"', place);
    // A device or a pipe could be read for ever.
    if (!fs::is_regular_file(status)) throw UserError('"' + file.string() + "\" is not a file", place);
    if (fs::file_size(file, error) > maxFileSize) throw UserError('"' + file.string() + "\" is too large", place);
    std::ifstream in(file, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (!in) throw UserError("cannot read file \"" + file.string() + '"', place);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw UserError('"' + file.string() + "\" is UTF-16: save it as UTF-8", place);
    text.erase(0, byteOrderMark(text));
    return text;
}

std::optional<fs::path> findEtc(const fs::path& name) {
    for (const auto& folder : etcFolders()) {
        std::error_code error;
        if (fs::is_regular_file(folder / name, error)) return folder / name;
    }
    return std::nullopt;
}

std::optional<fs::path> findFunction(const std::string& name) {
    for (const auto& folder : etcFolders()) {
        std::error_code error;
        std::vector<fs::path> matching;
        for (const auto& file : fs::recursive_directory_iterator(folder / "caseDicts/postProcessing", error)) {
            if (file.path().filename() == name && file.is_regular_file(error)) matching.push_back(file.path());
        }
        // The order of a folder's files is arbitrary
        if (!matching.empty()) return *std::min_element(matching.begin(), matching.end());
    }
    return std::nullopt;
}

namespace {

fs::path caseOf(const fs::path& file) {
    for (const char* variable : {"PFEM_CASE", "FOAM_CASE"}) {
        if (const auto folder = environment(variable); !folder.empty()) return folder;
    }
    std::error_code error;
    fs::path current = fs::current_path(error);
    for (fs::path folder = fs::absolute(file, error).parent_path(); folder.has_relative_path();
         folder = folder.parent_path()) {
        if (fs::exists(folder / "system/controlDict", error)) return folder;
    }
    return current;
}

}  // namespace

fs::path expandTags(const std::string& name, const fs::path& file) {
    const auto home = environment("HOME");
    if (!home.empty() && (name == "~" || name.starts_with("~/"))) return home + name.substr(1);
    if (!name.starts_with('<')) return name;
    const auto close = name.find('>');
    if (close == std::string::npos) return name;
    const std::string tag = name.substr(1, close - 1);
    std::string rest = name.substr(close + 1);
    if (rest.starts_with('/')) rest.erase(0, 1);
    if (tag == "etc") return findEtc(rest).value_or(rest);
    const fs::path caseDir = caseOf(file);
    if (tag == "case") return (caseDir / rest).lexically_normal();
    if (tag == "constant" || tag == "system") return caseDir / tag / rest;
    return name;
}

}  // namespace pfem
