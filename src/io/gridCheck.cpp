#include "io/gridCheck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace pfem {

namespace {

const std::string expectedStart =
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
    "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">";
const std::vector<std::string> elements = {
    "VTKFile",    "UnstructuredGrid",  "FieldData",  "DataArray",  "Array",           "Piece",
    "PointData",  "CellData",          "Points",     "Cells",      "InformationKey",  "Value",
    "/VTKFile",   "/UnstructuredGrid", "/FieldData", "/DataArray", "/Array",          "/Piece",
    "/PointData", "/CellData",         "/Points",    "/Cells",     "/InformationKey", "/Value"};
const std::vector<std::string> types = {"Float64", "Float32", "Int64", "Int32", "UInt8", "String"};

bool isOneOf(const std::string& word, const std::vector<std::string>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::uint64_t densest = 1032;  // zlib makes at most this many bytes of one

/// The value of attribute `name` in the tag that begins at `tag`, or nothing.
std::optional<std::string> attribute(const std::string& tag, const std::string& name) {
    const auto at = tag.find(" " + name + "=\"");
    if (at == std::string::npos) return {};
    const auto begin = at + name.size() + 3, end = tag.find('"', begin);
    if (end == std::string::npos) return {};
    return tag.substr(begin, end - begin);
}

/// A whole number without sign, blanks around it allowed (the writer pads), or nothing.
std::optional<std::uint64_t> wholeNumber(std::string text) {
    while (!text.empty() && text.back() == ' ') text.pop_back();
    while (!text.empty() && text.front() == ' ') text.erase(0, 1);
    if (text.empty() || text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos) return {};
    return std::stoull(text);
}

std::uint64_t wordAt(const char* bytes) {  // little endian, as this machine's
    std::uint64_t value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// One array's data: number of blocks, size of a block and of the last one before compression, compressed sizes.
std::string damageOfBlocks(const std::string& file, std::uint64_t begin) {
    if (begin > file.size() || file.size() - begin < 8) return "begins behind the end of the file";
    const std::uint64_t room = (file.size() - begin) / 8, blocks = wordAt(&file[begin]);
    if (blocks == 0) return "";
    if (room < 3 || blocks > room - 3) return "has more blocks than the file can hold";
    const std::uint64_t size = wordAt(&file[begin + 8]), last = wordAt(&file[begin + 16]);
    if (size == 0 || last > size) return "has blocks of a wrong size";
    std::uint64_t left = file.size() - begin - 8 * (3 + blocks);
    for (std::uint64_t k = 0; k < blocks; ++k) {
        const std::uint64_t compressed = wordAt(&file[begin + 24 + 8 * k]);
        if (compressed > left) return "goes on behind the end of the file";
        left -= compressed;
        const std::uint64_t whole = k + 1 == blocks && last > 0 ? last : size;
        if (whole / densest > compressed) return "has blocks of a wrong size";
    }
    return "";
}

/// A number that a tag says, or what holds when it says nothing.
std::uint64_t declared(const std::string& tag, const char* name, std::uint64_t otherwise) {
    const auto text = attribute(tag, name);
    return text ? wholeNumber(*text).value_or(0) : otherwise;
}

/// Where in a file a tag stands.
struct Context {
    std::string section;  // PointData, Cells, ...
    std::uint64_t points = 0, cells = 0;

    void enter(const std::string& name, const std::string& tag) {
        if (isOneOf(name, {"FieldData", "PointData", "CellData", "Points", "Cells"})) section = name;
        if (name != "Piece") return;
        points = declared(tag, "NumberOfPoints", 0);
        cells = declared(tag, "NumberOfCells", 0);
    }

    /// Bytes of an array of numbers; nothing where the head does not say it.
    std::optional<std::uint64_t> bytes(const std::string& tag) const {
        const std::string type = attribute(tag, "type").value_or(""), name = attribute(tag, "Name").value_or("");
        if (type == "String" || (section == "Cells" && name == "connectivity")) return {};
        std::uint64_t tuples = cells;
        if (section == "FieldData") tuples = declared(tag, "NumberOfTuples", 0);
        if (section == "PointData" || section == "Points") tuples = points;
        const std::uint64_t components = declared(tag, "NumberOfComponents", 1);
        return tuples * components * (type.ends_with("64") ? 8 : type.ends_with("32") ? 4 : 1);
    }
};

/// Bytes that the blocks of sound data stand for.
std::uint64_t unpackedBytes(const char* head) {
    const std::uint64_t blocks = wordAt(head);
    if (blocks == 0) return 0;
    const std::uint64_t size = wordAt(head + 8), last = wordAt(head + 16);
    return last > 0 ? (blocks - 1) * size + last : blocks * size;
}

/// What is wrong with one tag `<...` and, of an array, with its data; `base`: where the data begin.
Damage damageOfTag(const std::string& file, std::string tag, std::uint64_t base, Context& context) {
    if (tag.ends_with("/")) tag.back() = ' ';
    std::string name = tag.substr(1, tag.find_first_of(" \n\t", 1) - 1);
    if (!isOneOf(name, elements)) return {"unknown element", 0, true};
    context.enter(name, tag);
    const std::string array = fmt::format("array '{}' ", attribute(tag, "Name").value_or("without name"));
    if (const auto type = attribute(tag, "type"); name.ends_with("Array") && (!type || !isOneOf(*type, types)))
        return {array + "has an unknown type", 0, true};
    if (name.ends_with("Array") && !attribute(tag, "Name")) return {array + "cannot be told from others", 0, true};
    for (const char* count : {"NumberOfPoints", "NumberOfCells", "NumberOfTuples", "NumberOfComponents"})
        if (const auto text = attribute(tag, count)) {
            const auto number = wholeNumber(*text);
            if (!number || *number > densest * file.size()) return {fmt::format("{} is '{}'", count, *text)};
        }
    if (attribute(tag, "format") != "appended") return {};
    const auto offset = wholeNumber(attribute(tag, "offset").value_or(""));
    if (!offset || *offset > file.size()) return {array + "has no place in the file"};
    const auto damage = damageOfBlocks(file, base + *offset);
    if (!damage.empty()) return {array + damage};
    const std::uint64_t bytes = unpackedBytes(&file[base + *offset]);
    if (const auto wanted = context.bytes(tag); wanted && bytes != *wanted)
        return {array + fmt::format("has {} bytes of data, not {}", bytes, *wanted)};
    if (context.section == "Cells" && bytes == 0 && context.cells > 0) return {array + "has no data"};
    return {};
}

}  // namespace

Damage damageOf(const std::string& file) {
    const auto appended = file.find("<AppendedData encoding=\"raw\">");
    if (appended == std::string::npos || file.rfind(expectedStart, 0) != 0)
        return {"not a file of this toolkit", 1, true};
    const auto lineAt = [&](std::size_t place) {
        return 1 + static_cast<int>(std::count(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
    };
    const auto base = file.find('_', appended);
    if (base == std::string::npos) return {"its data are missing", lineAt(appended)};
    Context context;
    for (auto begin = file.find('<'); begin < appended; begin = file.find('<', begin + 1)) {
        const auto end = file.find('>', begin);
        if (end == std::string::npos || end > appended + 40) return {"its head is not complete", lineAt(begin)};
        Damage damage = damageOfTag(file, file.substr(begin, end - begin), base + 1, context);
        damage.line = lineAt(begin);
        if (!damage.reason.empty()) return damage;
    }
    return {};
}

std::string brokenArray(const std::string& file, const Unpack& unpack, bool onlyStrings) {
    const auto appended = file.find("<AppendedData"), base = file.find('_', appended) + 1;
    for (auto begin = file.find('<'); begin < appended; begin = file.find('<', begin + 1)) {
        const std::string tag = file.substr(begin, file.find('>', begin) - begin);
        const bool ofStrings = attribute(tag, "type") == "String";
        if (attribute(tag, "format") != "appended" || (onlyStrings && !ofStrings)) continue;
        std::string name = attribute(tag, "Name").value_or("without name");
        const char* head = &file[base + *wholeNumber(*attribute(tag, "offset"))];
        const std::uint64_t blocks = wordAt(head), size = blocks > 0 ? wordAt(head + 8) : 0,
                            last = blocks > 0 ? wordAt(head + 16) : 0;
        const char* data = head + 8 * (3 + blocks);
        std::uint64_t strings = 0;  // each ends with a zero
        for (std::uint64_t k = 0; k < blocks; ++k) {
            const std::uint64_t n = wordAt(head + 24 + 8 * k);
            const auto bytes = unpack(data, n, k + 1 == blocks && last > 0 ? last : size);
            if (!bytes) return name;
            if (ofStrings) strings += static_cast<std::uint64_t>(std::count(bytes->begin(), bytes->end(), '\0'));
            data += n;
        }
        if (ofStrings && strings != declared(tag, "NumberOfTuples", 0) * declared(tag, "NumberOfComponents", 1))
            return name;
    }
    return "";
}

}  // namespace pfem
