#include "study/jobs.hpp"

#include <gtest/gtest.h>

namespace pfem {
namespace {

Jobs jobs() {
    return {"/opt/pfem/pfemSweep", "/home/me/my case", "/home/me/my case/sweep", {1, 3, 4, 5, 9}, 2, 4,
            {"--time=2:00:00"}};
}

TEST(Jobs, scriptOfTheArray) {
    const std::string text = slurmScript(jobs());
    for (const char* line : {"#SBATCH --array=1,3-5,9%2\n", "#SBATCH --cpus-per-task=4\n", "#SBATCH --time=2:00:00\n",
                             "exec '/opt/pfem/pfemSweep' '-case' '/home/me/my case' '-folder' 'sweep' '-run' "
                             "\"$SLURM_ARRAY_TASK_ID\"\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
    Jobs all = jobs();
    all.atOnce = 0;
    EXPECT_NE(slurmScript(all).find("--array=1,3-5,9\n"), std::string::npos);
}

TEST(Jobs, goOnUnlessTold) { EXPECT_FALSE(jobMustStop()); }

}  // namespace
}  // namespace pfem
