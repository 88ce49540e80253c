#include "study/jobs.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "case/interrupt.hpp"
#include "study/runProgram.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

const char* const starter = "PFEM_SWEEP_PROCESS";  // environment of jobs: who started them
const char* const stopFile = "PFEM_SWEEP_STOP";    // and the file that tells them to stop

/// What a command says on stdout and stderr, and its exit code.
struct Answer {
    int code = 0;
    std::string text;
};

Answer answerOf(const Command& command, const fs::path& folder) {
    const fs::path log = folder / ("log." + fs::path(command[0]).filename().string());
    fs::remove(log);
    const int code = runProgram(command, folder, log);
    std::string text = readText(log);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    return {code, text};
}

/// For the shell.
std::string quoted(const std::string& text) {
    std::string safe = "'";
    for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe + "'";
}

/// "1-4,7"
std::string ranges(const std::vector<int>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
        if (last > i) text += "-" + std::to_string(numbers[last]);
        i = last;
    }
    return text;
}

void demandLeftQueue(const fs::path& folder) {
    if (!fs::exists(folder / "slurmJob")) return;
    std::string job = readText(folder / "slurmJob");
    job = job.substr(0, job.find('\n'));
    const Answer answer = answerOf({"squeue", "--noheader", "--jobs=" + job}, folder);
    if (answer.code == 0 && !answer.text.empty())
        throw UserError(
            fmt::format("the job array {0} of this study is still in the queue: squeue -j {0}; scancel {0}", job));
}

}  // namespace

Command Jobs::command(const std::string& number) const {
    return {program, "-case", root.string(), "-folder", fs::relative(folder, root).string(), "-run", number};
}

bool hasGnuParallel() {
    FILE* pipe = popen("parallel --version 2> /dev/null < /dev/null", "r");
    if (!pipe) return false;
    char line[64] = "";
    const bool read = std::fgets(line, sizeof line, pipe) != nullptr;
    while (std::fgetc(pipe) != EOF) {
    }
    pclose(pipe);
    return read && std::string(line).starts_with("GNU parallel");
}

void runParallel(const Jobs& jobs, const std::function<void()>& tick) {
    const fs::path stop = jobs.folder / ".stop", log = jobs.folder / "log.parallel";
    fs::remove(stop);
    fs::remove(log);
    setenv(starter, std::to_string(getpid()).c_str(), 1);
    setenv(stopFile, stop.c_str(), 1);
    Command command{"parallel", "--jobs", std::to_string(jobs.atOnce), "--quote"};
    for (const auto& word : jobs.command("{}")) command.push_back(word);
    command.emplace_back(":::");
    for (const int number : jobs.numbers) command.push_back(std::to_string(number));
    runProgram(command, jobs.folder, log, [&] {
        if (interrupted()) writeAtomically(stop, "");
        tick();
    });
    fs::remove(stop);
}

bool jobMustStop() {
    const char *process = std::getenv(starter), *stop = std::getenv(stopFile);
    if (!process || !stop) return false;
    return fs::exists(stop) || kill(static_cast<pid_t>(std::atol(process)), 0) != 0;
}

std::string slurmScript(const Jobs& jobs) {
    std::string text = fmt::format(
        "#!/bin/sh\n"
        "# The unfinished cases of a study, one task each. Written by pfemSweep -submit.\n"
        "#SBATCH --job-name=pfemSweep\n"
        "#SBATCH --array={}{}\n"
        "#SBATCH --nodes=1\n"
        "#SBATCH --ntasks=1\n"
        "#SBATCH --cpus-per-task={}\n"
        "#SBATCH --output=log.slurm.%a\n"
        "#SBATCH --signal=B:TERM@60\n",  // before the time limit: the run writes its state
        ranges(jobs.numbers), jobs.atOnce > 0 ? fmt::format("%{}", jobs.atOnce) : "", jobs.processors);
    for (const auto& option : jobs.slurm) text += "#SBATCH " + option + "\n";
    text += "exec";
    for (const auto& word : jobs.command("")) text += " " + (word.empty() ? "\"$SLURM_ARRAY_TASK_ID\"" : quoted(word));
    return text + "\n";
}

std::string submit(const Jobs& jobs) {
    demandLeftQueue(jobs.folder);
    writeAtomically(jobs.folder / "job.sh", slurmScript(jobs));
    const Answer answer = answerOf({"sbatch", "--parsable", "job.sh"}, jobs.folder);
    if (answer.code != 0)
        throw UserError(fmt::format("sbatch refuses \"{}\":\n{}", (jobs.folder / "job.sh").string(), answer.text));
    const std::string job = answer.text.substr(answer.text.rfind('\n') + 1);
    writeAtomically(jobs.folder / "slurmJob", job.substr(0, job.find(';')) + "\n");
    return job.substr(0, job.find(';'));
}

}  // namespace pfem
