#pragma once
// Programs that mpirun starts many of: -parallel.

#include <functional>

#include "application/options.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

/// The option -parallel.
OptionsSpec parallelOption();

/// body(ranks): alone, or with -parallel in each of the processes that mpirun has started. The first of them alone has
/// a log. An error of one ends them all: one that all ranks meet is told by the first, another by the rank that has it.
/// Returns the exit code.
int together(const Options& options, const std::function<int(const Ranks&)>& body);

}  // namespace pfem
