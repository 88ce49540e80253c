// system/pfemSolution of the first tutorial teaches the defaults: what it says must be what the code does.

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "case/case.hpp"
#include "mesher/readMeshDict.hpp"
#include "solver/setup.hpp"

using namespace pfem;

namespace {

using Values = std::map<std::string, std::string>;

template <class Part>
void collect(const std::string& name, Part part, Values& values) {
    entriesDetail::Describer describer;
    part.entries(describer);
    for (const auto& row : describer.rows) values[name + "." + row.name] = row.defaultValue;
}

Values valuesOf(const Controls& controls) {
    Values values;
    collect("", controls.integration, values);
    collect("timeIntegration", controls.timeIntegration, values);
    collect("convergence", controls.convergence, values);
    collect("momentum", controls.momentum, values);
    collect("continuity", controls.continuity, values);
    collect("solid", controls.solid, values);
    collect("remeshing", controls.remeshing, values);
    return values;
}

TEST(Tutorials, pfemSolutionHoldsTheDefaults) {
    for (const char* folder : {"/tutorials/damBreakElasticWall", "/etc/templates/damBreak", "/etc/templates/gmsh"}) {
        const Case theCase(std::string(PFEM_SOURCE_DIR) + folder);
        const Values defaults = valuesOf(Controls{}), read = valuesOf(readControls(theCase));
        for (const auto& [key, value] : defaults) EXPECT_EQ(read.at(key), value) << folder << " " << key;
        EXPECT_TRUE(Dictionary::read(theCase.system("pfemSolution")).isDict("remeshing"));
    }
}

TEST(Tutorials, pfemSolutionHasNoUnknownEntry) {
    for (const char* name :
         {"damBreakElasticWall", "cantilever", "hydrostaticPlate", "mudColumn", "sloshing", "waveMaker"}) {
        const Case theCase(std::string(PFEM_SOURCE_DIR) + "/tutorials/" + name);
        testing::internal::CaptureStderr();
        readControls(theCase);
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << name;
    }
}

TEST(Tutorials, meshDictHasNoUnknownEntry) {
    const Case theCase(std::string(PFEM_SOURCE_DIR) + "/tutorials/damBreakElasticWall");
    const Dictionary dict = Dictionary::read(theCase.system("meshDict"));
    readMeshDict(dict, {"water", "rubber"}, 0);
    std::ostringstream out;
    warnUnused(dict, out);
    EXPECT_EQ(out.str(), "");
}

}  // namespace
