#pragma once
// system/sweepDict: what a study changes, how it runs, what it gathers.

#include <string>
#include <vector>

#include "case/case.hpp"
#include "study/parameter.hpp"
#include "study/result.hpp"

namespace pfem {

struct SweepEntries {
    std::string method;
    int samples = 0, seed = 1;
    std::string mesh = "pfemMesh", command = "pfemFsiFoam";
    int processors = 1;
    std::vector<std::string> slurm;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required(
            "method", method, "-",
            "grid: all combinations of the parameters' values; list: the first values of all, the second, and so "
            "on; latinHypercube: samples that divide each parameter's range evenly",
            oneOf({"grid", "list", "latinHypercube"}));
        v("samples", samples, "-", "latinHypercube: number of cases", atLeast(0));
        v("seed", seed, "-", "latinHypercube: another seed gives other samples, the same one the same", atLeast(0));
        v("mesh", mesh, "-", "what the shell runs in a case without a time folder");
        v("command", command, "-",
          "what the shell then runs, also to go on in a case that was cut off: \"pfemFsiFoam && pfemPostProcess\"");
        v("processors", processors, "-", "of each case: OMP_NUM_THREADS, and what Slurm is asked for", atLeast(1));
        v("slurm", slurm, "-", "more options of sbatch: (\"--time=2:00:00\" \"--partition=long\")");
    }
};

struct Sweep : SweepEntries {
    std::vector<Parameter> parameters;
    std::vector<Result> results;
    Location where;
};

/// Throws UserError. Warnings of unused entries go to stderr.
Sweep readSweep(const Dictionary& dict);

}  // namespace pfem
