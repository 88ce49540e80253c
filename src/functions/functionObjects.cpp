#include "functions/functionObjects.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace pfem {

namespace {

WriteControl readWriteControl(const Dictionary& dict) {
    const auto mode = dict.choice("writeControl", WriteControl::modes(), "timeStep");
    const double interval = dict.get("writeInterval", 1.0);
    try {
        return {mode, interval};
    } catch (const UserError& error) {
        dict.fatal("writeInterval", error.what());
    }
}

/// Of a function that is disabled or not asked for, no entry is reported as unused.
void takeAsRead(const Dictionary& dict) {
    for (const auto& key : dict.keys()) {
        if (dict.isDict(key)) takeAsRead(dict.subDict(key));
        else dict.reader(key);
    }
}

}  // namespace

template <int Dim>
FunctionObjects<Dim>::FunctionObjects(const Case& theCase, const Dictionary& dict,
                                      const std::string& startName, int precision,
                                      const std::function<bool(const Dictionary& entry)>& wanted,
                                      std::optional<double> resumeAt) {
    const Dictionary functions = dict.subDictOrEmpty("functions");
    for (const auto& name : functions.keys()) {
        if (!functions.isDict(name)) functions.fatal(name, "'" + name + "' in functions is not a dictionary");
        if (name.empty() || name[0] == '.' || name.find_first_of("/\"\n") != std::string::npos)
            functions.fatal(name, "'" + name + "' in functions cannot be the name of a folder in postProcessing");
        const Dictionary& entry = functions.subDict(name);
        if (!entry.get("enabled", true) || (wanted && !wanted(entry))) {
            takeAsRead(entry);
            continue;
        }
        const FunctionContext<Dim> context{name, theCase.postProcessing(name, startName), theCase.root(),
                                           entry.get("writePrecision", precision), startName, resumeAt};
        functions_.push_back({name, readWriteControl(entry), makeFunction<Dim>(entry, context)});
    }
}

template <int Dim>
void FunctionObjects<Dim>::start(const State<Dim>& state) {
    prepare(state);
    if (state.time.index == 0) executeAll(state);
}

template <int Dim>
void FunctionObjects<Dim>::prepare(const State<Dim>& state) {
    for (auto& entry : functions_) entry.function->start(state);
}

template <int Dim>
std::vector<std::string> FunctionObjects<Dim>::names() const {
    std::vector<std::string> names;
    for (const auto& entry : functions_) names.push_back(entry.name);
    return names;
}

template <int Dim>
void FunctionObjects<Dim>::execute(const State<Dim>& state) {
    forAll(size(), [&](int k) {
        auto& entry = functions_[k];
        entry.function->advance(state);
        if (entry.control.due(state.time)) entry.function->execute(state);
    });
}

template <int Dim>
void FunctionObjects<Dim>::executeAll(const State<Dim>& state) {
    for (auto& entry : functions_) {
        entry.function->advance(state);
        entry.function->execute(state);
    }
}

template <int Dim>
std::map<std::string, std::vector<double>> FunctionObjects<Dim>::memory() const {
    std::map<std::string, std::vector<double>> all;
    for (const auto& entry : functions_)
        if (auto numbers = entry.function->memory(); !numbers.empty()) all[entry.name] = std::move(numbers);
    return all;
}

template <int Dim>
bool FunctionObjects<Dim>::wantAppeared() const {
    return std::any_of(functions_.begin(), functions_.end(), [](const Entry& entry) { return entry.function->wantsAppeared(); });
}

template class FunctionObjects<2>;

}  // namespace pfem
