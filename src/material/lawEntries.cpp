#include "material/lawEntries.hpp"

#include <fmt/format.h>

#include <cctype>

#include "dictionary/dimensions.hpp"

namespace pfem {

std::array<double, 7> dimensionsOfUnit(const std::string& unit, const std::map<std::string, double>& exponents) {
    if (unit == "-") return {};
    std::string text;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        if (unit[i] == '^') {  // by name
            const std::string name = unit.substr(i + 1, unit.find(' ', i) - i - 1);
            text += fmt::format("^{}", exponents.at(name));
            i += name.size();
            continue;
        }
        if (std::isdigit(static_cast<unsigned char>(unit[i])) && i > 0 &&
            std::isalpha(static_cast<unsigned char>(unit[i - 1])))
            text += '^';
        text += unit[i];
    }
    const Dictionary dict = Dictionary::parse("unit [" + text + "];", "unit");
    TokenReader reader = dict.reader("unit");
    return readDimensions(reader);
}

}  // namespace pfem
