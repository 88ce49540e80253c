#pragma once
// <case>/failed: what a run that could not go on leaves for the eye.

#include <filesystem>
#include <string>

#include "conditions/problem.hpp"
#include "solver/failedStep.hpp"

namespace pfem {

/// Write <root>/failed: fluid.vtu, solid.vtu and boundary.vtu with the last try and the flag `failed` on the nodes that
/// are concerned, failed.pvd to open them at once, and `reason` with the message. It is no time folder: no run starts
/// from it. Returns the nodes concerned, a line each. Throws UserError when it cannot be written.
template <int Dim>
std::string writeFailed(const std::filesystem::path& root, const Problem<Dim>& problem, const FailedStep<Dim>& failure,
                        const State<Dim>& last);

}  // namespace pfem
