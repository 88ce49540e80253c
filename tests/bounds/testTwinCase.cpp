#include "base/error.hpp"
#include "bounds/twinCase.hpp"
#include "dictionary/dictionary.hpp"
#include "study/runCase.hpp"
#include "support/folder.hpp"

namespace pfem {
namespace {

class Twins : public test::Folder {
protected:
    Twins() {
        put("system/controlDict", "#include \"../common\"\nstartFrom startTime; endTime $end; deltaT 0.1;\n");
        put("common", "end 2;\n");
        put("system/meshDict", "meshSize 0.5;\n");
        put("system/pfemSolution", "integration nodal; solid { damping 0.2; }\n");
        put("constant/g", "value (0 -9.81 0);\n");
        put("constant/wave.csv", "0,1\n");
    }

    Dictionary of(const TwinCase& twin, const char* file) const { return Dictionary::read(twin.root / file); }
    /// Files by which a folder counts as a time.
    void addTime(const TwinCase& twin, const std::string& time) const {
        for (const char* file : {"uniform/time", "fluid.vtu", "solid.vtu", "boundary.vtu"})
            put(std::filesystem::relative(twin.root, root) / time / file, "");
    }
};

TEST_F(Twins, saidByTheirDictionaries) {
    const Case theCase(root);
    EXPECT_EQ(meshSizeOf(theCase), 0.5);
    const auto twins = twinCases(theCase, "bounds", {0.25, 0.5});
    ASSERT_EQ(twins.size(), 4u);
    EXPECT_EQ(twins[0].name(), "nodal-0.5");
    EXPECT_EQ(twins[3].root, root / "bounds" / "elemental-0.25");
    for (const auto& twin : twins) prepareTwin(theCase, twin, {}, false);
    EXPECT_EQ(sizesIn(root / "bounds"), (std::vector<double>{0.5, 0.25}));
    EXPECT_EQ(of(twins[0], "system/pfemSolution").get<std::string>("integration"), "nodal");
    EXPECT_EQ(of(twins[1], "system/pfemSolution").get<std::string>("integration"), "elemental");
    EXPECT_EQ(of(twins[1], "system/pfemSolution").subDict("solid").get<double>("damping"), 0.2);
    EXPECT_EQ(of(twins[1], "system/controlDict").get<std::string>("startFrom"), "latestTime");
    EXPECT_EQ(of(twins[1], "system/controlDict").get<double>("endTime"), 2);  // the include is resolved
    EXPECT_TRUE(std::filesystem::exists(twins[2].root / "constant/wave.csv"));
    prepareTwin(theCase, twins[0], 0.75, false);
    EXPECT_EQ(reachedTime(twins[0].root).endTime, 0.75);
}

TEST_F(Twins, solidsAreAsTheFluid) {
    put("system/pfemSolution", "integration nodal; solid { integration elemental; }\n");
    for (const auto& twin : twinCases(Case(root), "bounds", {1})) {
        prepareTwin(Case(root), twin, {}, false);
        EXPECT_EQ(of(twin, "system/pfemSolution").subDict("solid").get<std::string>("integration"), "asFluid");
    }
}

TEST_F(Twins, withoutPfemSolution) {
    std::filesystem::remove(root / "system/pfemSolution");
    const auto twins = twinCases(Case(root), "bounds", {1});
    prepareTwin(Case(root), twins[1], {}, false);
    EXPECT_EQ(of(twins[1], "system/pfemSolution").get<std::string>("integration"), "elemental");
}

TEST_F(Twins, reachedTime) {
    const auto twins = twinCases(Case(root), "bounds", {1});
    prepareTwin(Case(root), twins[0], {}, false);
    EXPECT_FALSE(reachedTime(twins[0].root).latest);
    addTime(twins[0], "1.9");
    EXPECT_FALSE(reachedTime(twins[0].root).finished());
    addTime(twins[0], "2");
    EXPECT_TRUE(reachedTime(twins[0].root).finished());
    prepareTwin(Case(root), twins[0], 3, false);  // longer: goes on
    EXPECT_FALSE(reachedTime(twins[0].root).finished());
}

// Results of other physics must not pass for those of this case.
TEST_F(Twins, changedDictionaries) {
    const Case theCase(root);
    const auto twins = twinCases(theCase, "bounds", {1});
    prepareTwin(theCase, twins[0], {}, false);
    put("constant/g", "value (0 -1.6 0);\n");
    prepareTwin(theCase, twins[0], {}, false);  // nothing computed yet: taken over
    EXPECT_EQ(of(twins[0], "constant/g").get<Eigen::Vector3d>("value")[1], -1.6);
    addTime(twins[0], "0");
    put("constant/g", "value (0 -3.7 0);\n");
    try {
        prepareTwin(theCase, twins[0], {}, false);
        FAIL();
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("constant/g"), std::string::npos);
    }
    prepareTwin(theCase, twins[0], {}, true);
    EXPECT_FALSE(std::filesystem::exists(twins[0].root / "0"));
}

TEST_F(Twins, badSizes) {
    for (const std::vector<double>& sizes : {std::vector<double>{0}, {-1}, {1, 1}, {1, 0.999}})
        EXPECT_THROW(twinCases(Case(root), "bounds", sizes), UserError);
}

}  // namespace
}  // namespace pfem
