#include <filesystem>

#include "dictionary/files.hpp"
#include "dictionary/function1Types.hpp"

namespace pfem::function1Detail {

/// ((t value) (t value) ...)
template <class T>
Pairs<T> readPairs(TokenReader& tokens) {
    Pairs<T> pairs;
    tokens.list([&] {
        tokens.open();
        const auto t = tokens.read<double>();
        pairs.emplace_back(t, tokens.read<T>());
        tokens.close();
    });
    return pairs;
}

/// ((coefficient exponent) ...)
template <class T>
std::vector<std::pair<T, T>> readTerms(TokenReader& tokens) {
    std::vector<std::pair<T, T>> terms;
    tokens.list([&] {
        tokens.open();
        const auto c = tokens.read<T>();
        terms.emplace_back(c, tokens.read<T>());
        tokens.close();
    });
    return terms;
}

/// "formula" or ("x" "y" "z").
template <class T>
std::vector<std::string> readFormulas(TokenReader& tokens) {
    if constexpr (std::is_same_v<T, double>) {
        return {tokens.read<std::string>()};
    } else {
        auto formulas = tokens.read<std::vector<std::string>>();
        if (formulas.size() != 3) tokens.fatal("a vector needs three formulas: (\"0.1*t\" \"0\" \"0\")");
        return formulas;
    }
}

template <class T>
WaveEntries<T> readWave(const Dictionary& dict, bool square) {
    WaveEntries<T> e;
    e.square = square;
    if (dict.found("period") && dict.found("frequency")) dict.fatal("period", "Give either frequency or period");
    e.frequency = dict.found("period") ? 1 / dict.get<double>("period") : dict.get<double>("frequency");
    if (!(e.frequency > 0 && e.frequency < 1e300))
        dict.fatal(dict.found("period") ? "period" : "frequency", "frequency and period must be positive");
    e.start = dict.get("start", dict.get("t0", 0.0));
    if (dict.found("amplitude"))
        e.amplitude = readFunction1<double>(dict, "amplitude");
    else
        e.amplitude = std::make_shared<Constant<double>>(1.0);
    if constexpr (std::is_same_v<T, double>) {
        e.scale = dict.get("scale", 1.0);
        e.level = dict.get("level", 0.0);
    } else {
        e.scale = dict.get<Eigen::Vector3d>("scale");
        e.level = dict.get("level", Eigen::Vector3d(Eigen::Vector3d::Zero()));
    }
    if (square) {
        e.markSpace = dict.get("markSpace", 1.0);
        if (!(e.markSpace > 0)) dict.fatal("markSpace", "markSpace must be positive");
    }
    return e;
}

/// `file "<path>";` relative to the dictionary's folder: the list of a table alone.
template <class T>
Pairs<T> readTableFile(const Dictionary& dict) {
    std::filesystem::path file = dict.get<std::string>("file");
    if (file.is_relative()) file = std::filesystem::path(dict.where("file").file).parent_path() / file;
    const Dictionary table = Dictionary::parse("values " + fileText(file, dict.where("file")) + "\n;", file.string());
    TokenReader tokens = table.reader("values");
    Pairs<T> pairs = readPairs<T>(tokens);
    tokens.end();
    return pairs;
}

OutOfBounds readOutOfBounds(const Dictionary& dict) {
    const std::string word = dict.choice("outOfBounds", {"clamp", "repeat", "error"}, "clamp");
    return word == "clamp" ? OutOfBounds::clamp : word == "repeat" ? OutOfBounds::repeat : OutOfBounds::error;
}

#define PFEM_INSTANTIATE(T)                                           \
    template Pairs<T> readPairs<T>(TokenReader&);                     \
    template std::vector<std::pair<T, T>> readTerms<T>(TokenReader&); \
    template std::vector<std::string> readFormulas<T>(TokenReader&);  \
    template WaveEntries<T> readWave<T>(const Dictionary&, bool);     \
    template Pairs<T> readTableFile<T>(const Dictionary&);
PFEM_INSTANTIATE(double)
PFEM_INSTANTIATE(Eigen::Vector3d)

}  // namespace pfem::function1Detail
