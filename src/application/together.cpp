#include "application/together.hpp"

#include <chrono>
#include <iostream>
#include <streambuf>
#include <thread>

#include "application/runApplication.hpp"
#include "base/error.hpp"

namespace pfem {

namespace {

/// What goes to std::cout and std::cerr is lost while it lives.
class Silence {
public:
    Silence() : out_(std::cout.rdbuf(&nothing_)), error_(std::cerr.rdbuf(&nothing_)) {}
    ~Silence() {
        std::cout.rdbuf(out_);
        std::cerr.rdbuf(error_);
    }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

private:
    struct Nothing : std::streambuf {
        int overflow(int c) override { return traits_type::not_eof(c); }
    };
    Nothing nothing_;
    std::streambuf *out_, *error_;
};

/// Errors of the case and of the step: all ranks have the same case and compute the same.
bool allMeet(const std::exception& error) {
    return dynamic_cast<const UserError*>(&error) != nullptr || dynamic_cast<const StepFailure*>(&error) != nullptr;
}

}  // namespace

OptionsSpec parallelOption() {
    OptionsSpec spec;
    spec.add("parallel", "", "share the run with the other processes that mpirun has started");
    return spec;
}

int together(const Options& options, const std::function<int(const Ranks&)>& body) {
    if (!options.found("parallel")) return body(Ranks());
    const Ranks ranks = Ranks::all();
    try {
        if (ranks.isFirst()) return body(ranks);
        const Silence silence;
        return body(ranks);
    } catch (const std::exception& error) {
        if (ranks.isAlone()) throw;
        constexpr std::chrono::seconds patience(60);  // the first one writes the state, tells why and ends all
        if (!ranks.isFirst() && allMeet(error)) std::this_thread::sleep_for(patience);
        std::cout.flush();
        std::cerr << fatalText(error);
        if (!ranks.isFirst()) std::cerr << "    in rank " << ranks.rank() << " of " << ranks.size() << "\n\n";
        std::cerr.flush();
        ranks.abort(1);
    }
}

}  // namespace pfem
