#pragma once
// PETSc's matrices by threads: its own kernels are serial in one process.

#include <petscksp.h>

namespace pfem {

/// Products with a matrix of one process (AIJ), y = A x, w = y + A x, row by row.
void multiplyByThreads(::Mat A);

/// Products on all levels of a multigrid (PCMG) of one process that has been set up, and its symmetric Gauss-Seidel
/// sweeps: in blocks of rows at the same time, each with what the others had before the sweep. How many blocks depends
/// on the number of rows alone, and so do the bits.
void cycleByThreads(::PC multigrid);

}  // namespace pfem
