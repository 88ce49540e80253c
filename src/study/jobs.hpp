#pragma once
// Many cases at once: by GNU parallel on this machine, or as a job array of Slurm.
//
// A job is the program itself with `-run <number>`: it goes on with one case. So both engines resume as one process
// does.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/runCase.hpp"

namespace pfem {

/// What a job needs to know.
struct Jobs {
    std::string program;           // with its folder
    std::filesystem::path root;    // the case
    std::filesystem::path folder;  // of the study
    std::vector<int> numbers;      // of the cases to be run
    int atOnce = 1;                // cases at the same time; Slurm: 0 is no limit
    int processors = 1;            // of each
    std::vector<std::string> slurm;

    Command command(const std::string& number) const;  // of one job
};

/// Is `parallel` GNU parallel? (Another program has the same name.)
bool hasGnuParallel();

/// Run all by GNU parallel, their words to log.parallel in the study's folder; `tick` is called about once a second. A
/// job that fails does not stop the others. SIGTERM: those that run stop in their own way. Throws UserError.
void runParallel(const Jobs& jobs, const std::function<void()>& tick);

/// A job asks whether to stop: the process that started it (by GNU parallel) has been told to, or is gone.
bool jobMustStop();

/// The script for sbatch: an array, one task per case.
std::string slurmScript(const Jobs& jobs);

/// Write job.sh, submit it and keep the array's number in slurmJob; returns the number. Throws UserError when sbatch
/// refuses, or when the array of an earlier call is still in the queue.
std::string submit(const Jobs& jobs);

}  // namespace pfem
