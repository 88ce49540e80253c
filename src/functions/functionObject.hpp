#pragma once
// What is computed beside the solution while a run goes on (controlDict.functions), or afterwards by a
// utility.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "dictionary/dictionary.hpp"
#include "state/state.hpp"

namespace pfem {

/// What a function may know beside the state.
template <int Dim>
struct FunctionContext {
    std::string name;                     // the entry's name in `functions`
    std::filesystem::path folder;         // postProcessing/<name>/<startTime>
    std::filesystem::path root;           // of the case
    int precision = 6;                    // significant digits of the columns
    std::string startName;                // name of the time folder at which the run began
    std::optional<double> resumeAt = {};  // the exact time at which a run goes on: for Table; none for new tables
};

/// Several of a run work at the same time, each in a thread of its own (but see usesThreads): they share nothing that
/// they change.
template <int Dim>
class FunctionObject {
public:
    virtual ~FunctionObject() = default;

    /// Called once with the state at the start, before any execute().
    virtual void start(const State<Dim>& state) = 0;

    /// After every step, also when no row is due: for what sums or filters over time. Called before execute().
    virtual void advance(const State<Dim>&) {}

    /// Numbers that a restart needs; start() finds them again in State::memory under the function's name.
    virtual std::vector<double> memory() const { return {}; }

    /// Shall the run count where volume appears (the ledger's fields) and write it into its time folders?
    virtual bool wantsAppeared() const { return false; }

    /// Has it so much to do in each step that it uses all threads itself? Then it does not work beside the others.
    virtual bool usesThreads() const { return false; }

    /// Evaluate the state and write a row. Throws UserError when the file cannot be written.
    virtual void execute(const State<Dim>& state) = 0;
};

/// The state from which the run started first: that of the earliest complete time folder, or `state` itself
/// when there is none before it. Functions that compare with the beginning ask for it, so that a restarted
/// run gives the same answer.
template <int Dim>
State<Dim> initialState(const std::filesystem::path& root, const State<Dim>& state);

/// Makes a function from its entry.
template <int Dim>
using FunctionFactory = std::unique_ptr<FunctionObject<Dim>> (*)(const Dictionary&, const FunctionContext<Dim>&);

/// A type from outside the library, for `type` in controlDict: call it before the first dictionary is read, or from the
/// initialiser of a static object in the file of the type. Returns false when there is the type already.
template <int Dim>
bool addFunctionType(const std::string& type, FunctionFactory<Dim> factory);

/// The words for `type`.
std::vector<std::string> functionTypes();

/// Make a function of the type that `dict` names. Throws UserError, for an unknown type with the valid list.
template <int Dim>
std::unique_ptr<FunctionObject<Dim>> makeFunction(const Dictionary& dict, const FunctionContext<Dim>& context);

}  // namespace pfem
