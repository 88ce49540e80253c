#pragma once
// A case folder for functions that read the physics themselves, and their tables as numbers.

#include <fstream>
#include <iterator>
#include <sstream>

#include "../io/sampleState.hpp"
#include "base/atomicFile.hpp"
#include "functions/functionObjects.hpp"
#include "support/cases.hpp"

namespace pfem::test {

/// constant/ of a case in a temporary folder.
class CaseFolder {
public:
    CaseFolder(const std::string& materials, const std::string& conditions, const std::string& g = "(0 -10 0)") {
        std::filesystem::create_directories(folder_.path() / "constant");
        std::ofstream(folder_.path() / "constant/materials") << materials;
        std::ofstream(folder_.path() / "constant/boundaryConditions") << conditions;
        std::ofstream(folder_.path() / "constant/g") << "value " << g << ";";
    }
    const std::filesystem::path& path() const { return folder_.path(); }

    template <int Dim = 2>
    FunctionObjects<Dim> functions(const std::string& text, const std::string& startName = "0") const {
        return {Case(folder_.path()), Dictionary::parse("functions { " + text + " }", "controlDict"), startName, 12};
    }
    std::string text(const std::string& file) const { return readText(folder_.path() / "postProcessing" / file); }

    /// Rows of a table, comments left out; brackets are blanks.
    std::vector<std::vector<double>> rows(const std::string& file) const {
        std::istringstream lines(text(file));
        std::vector<std::vector<double>> table;
        for (std::string line; std::getline(lines, line);) {
            if (line[0] == '#') continue;
            for (char& c : line)
                if (c == '(' || c == ')') c = ' ';
            std::istringstream words(line);
            table.emplace_back(std::istream_iterator<double>(words), std::istream_iterator<double>());
        }
        return table;
    }

private:
    TemporaryFolder folder_;
};

/// Water 1 m x 0.5 m in a tank of three walls, floor first; hydrostatic pressure for g = 10.
inline State<2> tank(double h = 0.1) {
    State<2> state = makeCase("meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " +
                                  rectangle(0, 0, 1, 0.5) +
                                  " } ); walls ( floor { points ((0 0) (1 0)); } "
                                  "right { points ((1 0) (1 1)); } left { points ((0 1) (0 0)); } );",
                              water, "floor { type noSlip; } right { type slip; } left { type slip; }")
                         .state;
    for (int i = 0; i < state.nodes.size(); ++i) state.nodes.p[i] = 1e4 * (0.5 - state.nodes.x[i][1]);
    return state;
}

inline const char* const tankConditions = "floor { type noSlip; } right { type slip; } left { type slip; }";

}  // namespace pfem::test
