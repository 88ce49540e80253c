#pragma once
// What a case must not ask for although each of its words is valid.

#include <filesystem>
#include <string>
#include <vector>

#include "conditions/problem.hpp"
#include "dictionary/dictionary.hpp"
#include "momentum/controls.hpp"

namespace pfem {

/// Throws UserError at the material of a second fluid: remeshing joins all fluid that touches, as one material.
template <int Dim>
void checkOneFluid(const Dictionary& materials, const Mesh<Dim>& mesh);

/// Throws UserError at the entry of a patch whose condition is none for what it is: a rigid wall must be slip
/// or noSlip, an edge of a solid must not; only edges of solids can be clamped or carry a traction, and in
/// space be planes of symmetry. Also where walls and clamped edges with a common node do not move alike.
template <int Dim>
void checkConditions(const Dictionary& dict, const BoundaryConditions<Dim>& conditions, const State<Dim>& state);

/// Throws UserError naming `folder` when the state, whose numbers are finite, cannot be gone on from: a node without
/// mesh size, a solid's element without volume, a folder that was renamed.
template <int Dim>
void checkState(const std::filesystem::path& folder, const State<Dim>& state);

/// Throws UserError where nodal integration would have to take the mean of laws of different Kinematics: at a common
/// node of two solids.
template <int Dim>
void checkLaws(const Problem<Dim>& problem, const Mesh<Dim>& mesh, Integration ofSolids);

/// Sentences about numbers that can be computed but hardly be meant, each naming its entry with file and line: nothing
/// drives the case (no gravity, velocity, load or motion), gravity or weight of the fluid out of proportion,
/// waves that are short beside the mesh.
template <int Dim>
std::vector<std::string> doubts(const Dictionary& materials, const Dictionary& gravity, const Dictionary& conditions,
                                const Problem<Dim>& problem, const State<Dim>& state);

}  // namespace pfem
