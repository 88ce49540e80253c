#pragma once
// All functions of controlDict.functions, each at its own writeControl.

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "functions/functionObject.hpp"
#include "functions/rowControl.hpp"

namespace pfem {

template <int Dim>
class FunctionObjects {
public:
    /// `dict`: the dictionary that holds `functions`. `startName`: the time folder at which the run began;
    /// the tables go to postProcessing/<name>/<startName>, or continue those of the run before when `resumeAt` is
    /// the exact time at which it goes on. `wanted`: which entries of `functions` (empty: all). Those of a foreign type
    /// are left out with a warning. Throws UserError.
    FunctionObjects(const Case& theCase, const Dictionary& dict, const std::string& startName, int precision = 6,
                    const std::function<bool(const Dictionary& entry)>& wanted = {},
                    std::optional<double> resumeAt = {});

    /// With the state at the start. Rows are written only when that is the very first of the case (index 0),
    /// so that the tables of a restarted run join without a repeated row.
    void start(const State<Dim>& state);

    /// As start(), but never writes a row.
    void prepare(const State<Dim>& state);

    /// After each step: those whose writeControl says so write a row. `folderDue`: for writeControl writeTime.
    void execute(const State<Dim>& state, const FolderDue& folderDue = {});

    /// All of them write a row, whatever their writeControl (utilities that work on time folders), from timeStart to
    /// timeEnd.
    void executeAll(const State<Dim>& state);

    /// What the functions need to go on after a restart, for State::memory.
    std::map<std::string, std::vector<double>> memory() const;

    /// Does one of them want the ledger's fields?
    bool wantAppeared() const;

    /// The entries' names.
    std::vector<std::string> names() const;
    int size() const { return static_cast<int>(functions_.size()); }

private:
    struct Entry {
        std::string name;
        RowControl control;
        std::unique_ptr<FunctionObject<Dim>> function;
    };
    std::vector<Entry> functions_;
};

}  // namespace pfem
