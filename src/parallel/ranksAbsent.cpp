// In a build without MPI each process is alone.

#include <cstdlib>

#include "base/error.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

Ranks Ranks::all() { throw UserError("This build has no MPI (CMake's PFEM_PETSC): run without -parallel."); }
void Ranks::abort(int exitCode) const { std::_Exit(exitCode); }
void Ranks::broadcast(void*, std::size_t) const {}
std::vector<std::size_t> Ranks::endsOf(std::size_t mine) const { return {mine}; }
void Ranks::gatherInPlace(void*, const std::vector<std::size_t>&, std::size_t) const {}
void Ranks::gather(const void*, void*, const std::vector<std::size_t>&, std::size_t) const {}

}  // namespace pfem
