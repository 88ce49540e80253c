#include "io/uniformTime.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdint>

#include "base/error.hpp"
#include "dictionary/dictionary.hpp"
#include "io/textHeader.hpp"

namespace pfem {

namespace {

double finite(const std::string& name, double value) {
    if (!std::isfinite(value)) throw InternalError("uniform/time: '" + name + "' is not a finite number");
    return value;
}

const std::string& plainWord(const std::string& word) {
    bool plain = !word.empty() && std::isalpha(static_cast<unsigned char>(word[0]));
    for (const char c : word) plain = plain && (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.');
    if (!plain) throw InternalError("uniform/time: '" + word + "' cannot be a keyword");
    return word;
}

std::string entry(const std::string& name, double value) {
    return fmt::format("{:<15} {};\n", plainWord(name), finite(name, value));
}

double readFinite(const Dictionary& dict, const std::string& key) {
    const auto value = dict.get<double>(key);
    if (!std::isfinite(value)) dict.fatal(key, "'" + key + "' is not a finite number");
    return value;
}

double readStep(const Dictionary& dict, const std::string& key) {
    const double value = readFinite(dict, key);
    if (value < 0) dict.fatal(key, "'" + key + "' must not be negative");
    return value;
}

Id readWhole(const Dictionary& dict, const std::string& key, Id most) {
    const auto value = dict.get<std::int64_t>(key);
    if (value < 0 || value > most) dict.fatal(key, fmt::format("'{}' must be from 0 to {}", key, most));
    return value;
}

}  // namespace

std::string checksumOf(const std::string& bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return fmt::format("{}-{:016x}", bytes.size(), hash);
}

std::string formatUniformTime(const UniformTime& uniform, const std::string& folderName) {
    std::string text = dictionaryHeader("time", folderName + "/uniform");
    text += entry("value", uniform.time.value);
    text += fmt::format("{:<15} \"{}\";\n", "name", folderName);
    text += fmt::format("{:<15} {};\n", "index", uniform.time.index);
    text += entry("deltaT", uniform.time.deltaT);
    text += entry("deltaT0", uniform.time.deltaT0);
    text += fmt::format("{:<15} {};\n", "nextId", uniform.nextId);
    text += entry("approach", uniform.approach) + "\n";
    text += "// Cumulative fluid volume by cause [m2 in 2D, m3 in 3D]\nledger\n{\n";
    for (const auto& [cause, volume] : uniform.ledger) text += "    " + entry(cause, volume);
    text +=
        "}\n\n// Cumulative energy that came with volume and remeshing, not by the equations [J/m in 2D, J in "
        "3D]\nenergy\n{\n";
    for (const auto& [cause, amount] : uniform.energy) text += "    " + entry(cause, amount);
    text += "}\n\nchecksums\n{\n";
    for (const auto& [file, sum] : uniform.checksums) text += fmt::format("    {:<15} \"{}\";\n", plainWord(file), sum);
    text += "}\n";
    if (!uniform.memory.empty()) text += "\n// What function objects remember\nmemory\n(\n";
    for (const auto& [name, numbers] : uniform.memory) {
        text += fmt::format("    {{ function \"{}\"; values (", name);
        for (const double number : numbers) text += fmt::format(" {}", finite(name, number));
        text += " ); }\n";
    }
    if (!uniform.memory.empty()) text += ");\n";
    return text + "\n" + dictionaryEndLine();
}

UniformTime readUniformTime(const std::filesystem::path& folder) {
    const Dictionary dict = Dictionary::read(folder / "uniform" / "time");
    UniformTime uniform;
    uniform.time.value = readFinite(dict, "value");
    uniform.time.index = static_cast<int>(readWhole(dict, "index", 2000000000));
    uniform.time.deltaT = readStep(dict, "deltaT");
    uniform.time.deltaT0 = readStep(dict, "deltaT0");
    uniform.name = dict.get("name", "");
    uniform.nextId = readWhole(dict, "nextId", Id{1} << 60);
    if (dict.found("approach")) uniform.approach = readStep(dict, "approach");  // folders of older versions have none
    const Dictionary ledger = dict.subDict("ledger");
    for (const auto& cause : ledger.keys()) uniform.ledger[cause] = readFinite(ledger, cause);
    if (dict.found("energy")) {  // folders of older versions have none
        const Dictionary energy = dict.subDict("energy");
        for (const auto& cause : energy.keys()) uniform.energy[cause] = readFinite(energy, cause);
    }
    const Dictionary sums = dict.subDict("checksums");
    for (const auto& file : sums.keys()) uniform.checksums[file] = sums.get<std::string>(file);
    if (dict.found("memory"))
        for (const auto& entry : dict.dictList("memory")) {
            auto& numbers = uniform.memory[entry.get<std::string>("function")];
            numbers = entry.get<std::vector<double>>("values");
            for (const double number : numbers)
                if (!std::isfinite(number)) entry.fatal("values", "a value is not a finite number");
        }
    return uniform;
}

}  // namespace pfem
