#pragma once
// The two kinds of failure: what a user can mend (UserError) and our own bugs (InternalError).

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace pfem {

/// Where in a user's file an error was found. line 0: the file as a whole.
struct Location {
    std::string file;
    int line = 0;
    int lastLine = 0;  ///< of a dictionary that was found wanting; 0: one line only
};

/// "file:12", or "file" for the file as a whole: for warnings.
std::string toString(const Location& where);

/// A mistake in a dictionary, mesh, file or command line. Printed by the application in
/// OpenFOAM's form ("--> FOAM FATAL IO ERROR:"), exit code 1.
class UserError : public std::runtime_error {
public:
    explicit UserError(const std::string& message, Location where = {})
        : std::runtime_error(message), where_(std::move(where)) {}
    const Location& where() const { return where_; }

private:
    Location where_;
};

/// A broken promise inside the library: a bug to be reported.
class InternalError : public std::logic_error {
    using std::logic_error::logic_error;
};

/// A time step that cannot be accepted (no convergence, inverted element, ...). The step is repeated
/// with a smaller deltaT; the message says why and where; `nodes`: the ids of those concerned, if known.
class StepFailure : public std::runtime_error {
public:
    explicit StepFailure(const std::string& message, std::vector<std::int64_t> nodes = {})
        : std::runtime_error(message), nodes_(std::move(nodes)) {}
    const std::vector<std::int64_t>& nodes() const { return nodes_; }

private:
    std::vector<std::int64_t> nodes_;
};

/// "<word> is not a valid <what>.\nValid <what>s :\n3\n(\na\nb\nc\n)" with the nearest valid word as a hint.
std::string notValid(const std::string& word, const std::string& what, const std::vector<std::string>& valid);

/// The word of `valid` that is nearest to `word` (Levenshtein distance at most a third of its length), or "".
std::string nearestWord(const std::string& word, const std::vector<std::string>& valid);

}  // namespace pfem
