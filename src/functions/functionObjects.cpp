#include "functions/functionObjects.hpp"

#include <algorithm>
#include <iostream>

#include "base/parallel.hpp"
#include "functions/functionEntries.hpp"

namespace pfem {

namespace {

/// A function of another program, as in a controlDict that serves both, is left out.
void warnOfForeign(const Dictionary& entry) {
    std::cerr << "--> PFEM Warning: function '" << entry.keyword() << "' in " << toString(entry.where("type"))
              << " is left out. " << notValid(entry.get<std::string>("type"), "function type", functionTypes()) << "\n";
}

}  // namespace

template <int Dim>
FunctionObjects<Dim>::FunctionObjects(const Case& theCase, const Dictionary& dict, const std::string& startName,
                                      int precision, const std::function<bool(const Dictionary& entry)>& wanted,
                                      std::optional<double> resumeAt) {
    for (const auto& entry : functionEntries(dict)) {
        const bool left = !entry.get("enabled", true) || (wanted && !wanted(entry));
        if (left || isForeignFunction(entry)) {
            if (!left) warnOfForeign(entry);
            takeAsRead(entry);
            continue;
        }
        const std::string name = entry.keyword();
        const FunctionContext<Dim> context{name,           theCase.postProcessing(name, startName),
                                           theCase.root(), entry.get("writePrecision", precision),
                                           startName,      resumeAt};
        functions_.push_back({name, RowControl(entry), makeFunction<Dim>(entry, context)});
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
void FunctionObjects<Dim>::execute(const State<Dim>& state, const FolderDue& folderDue) {
    const auto run = [&](Entry& entry) {
        entry.function->advance(state);
        if (entry.control.due(state.time, folderDue)) entry.function->execute(state);
    };
    std::vector<Entry*> sideBySide;
    for (auto& entry : functions_) {
        if (entry.function->usesThreads())
            run(entry);
        else
            sideBySide.push_back(&entry);
    }
    parallelTasks(static_cast<int>(sideBySide.size()), [&](int k) { run(*sideBySide[k]); });
}

template <int Dim>
void FunctionObjects<Dim>::executeAll(const State<Dim>& state) {
    for (auto& entry : functions_) {
        entry.function->advance(state);
        if (entry.control.inWindow(state.time)) entry.function->execute(state);
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
    return std::any_of(functions_.begin(), functions_.end(),
                       [](const Entry& entry) { return entry.function->wantsAppeared(); });
}

#define PFEM_INSTANTIATE(D) template class FunctionObjects<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
