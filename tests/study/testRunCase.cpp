#include "study/runCase.hpp"

#include <sys/stat.h>

#include <sstream>

#include "sweepCase.hpp"

namespace pfem {
namespace {

// The shell stands for mesher and solver: it makes folders that count as times.
class Running : public test::SweepFolder {
protected:
    Running() {
        put("time",
            "#!/bin/sh\nmkdir -p $1/uniform; touch $1/uniform/time $1/fluid.vtu $1/solid.vtu $1/boundary.vtu\n");
    }

    StudyCommands commands(const std::string& solve) const {
        return {.mesh = shellCommand("echo mesh >> done; sh ./time 0"),
                .solve = shellCommand("echo solve >> done; " + solve)};
    }
    std::string done() const {
        std::ifstream stream(root / "done");
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    std::ostringstream out;
};

TEST_F(Running, meshesOnceAndGoesOn) {
    EXPECT_NE(complaint([&] { runCase(root, "it", commands("sh ./time 1; exit 3"), out); }).find("exit code 3"),
              std::string::npos);
    EXPECT_FALSE(reachedTime(root).finished());
    runCase(root, "it", commands("sh ./time 2"), out);
    EXPECT_EQ(done(), "mesh\nsolve\nsolve\n");
    EXPECT_TRUE(reachedTime(root).finished());
    runCase(root, "it", commands("sh ./time 2"), out);
    EXPECT_EQ(done(), "mesh\nsolve\nsolve\n");
    EXPECT_EQ(out.str(), "it: from 0 to 2 s\nit: from 1 to 2 s\nit: finished\n");
}

// The last time is there, but what should follow was cut off.
TEST_F(Running, isNotFinishedBeforeTheCommandHasEnded) {
    EXPECT_NE(complaint([&] { runCase(root, "it", commands("sh ./time 2 && false"), out); }), "");
    EXPECT_FALSE(reachedTime(root).finished());
    runCase(root, "it", commands("true"), out);
    EXPECT_TRUE(reachedTime(root).finished());
}

TEST_F(Running, endsTooEarly) {
    EXPECT_NE(complaint([&] { runCase(root, "it", commands("sh ./time 1"), out); }).find("has not reached its endTime"),
              std::string::npos);
}

TEST_F(Running, logBearsTheProgramsName) {
    runCase(root, "it", {.mesh = shellCommand("A=1 /bin/sh ./time 0"), .solve = shellCommand("sh ./time 2")}, out);
    EXPECT_TRUE(std::filesystem::exists(root / "log.sh"));
}

}  // namespace
}  // namespace pfem
