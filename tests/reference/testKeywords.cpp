// The keyword reference is complete and doc/keywords.md is what the programs print.

#include "reference/keywords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "conditions/boundaryConditions.hpp"
#include "dictionary/node.hpp"
#include "functions/functionObject.hpp"
#include "material/material.hpp"
#include "mesher/readMeshDict.hpp"
#include "mesher/space/readSpaceDict.hpp"
#include "study/sweep.hpp"

using namespace pfem;

namespace {

std::set<std::string> names(const std::vector<KeywordTable>& tables) {
    std::set<std::string> all;
    for (const auto& table : tables)
        for (const auto& row : table.rows) all.insert(row.name);
    return all;
}

/// All keywords that a reader has asked for, in the dictionary and below; those in `own` are the user's own
/// names.
void expectDocumented(const DictionaryNode& node, const std::set<std::string>& documented,
                      const std::set<std::string>& own) {
    for (const auto& key : node.lookedUp)
        EXPECT_TRUE(documented.count(key) || own.count(key))
            << "'" << key << "' of " << node.name << " is not documented";
    for (const auto& entry : node.entries) {
        if (entry.dict) expectDocumented(*entry.dict->node(), documented, own);
        EXPECT_TRUE(entry.used) << "the test should read " << entry.key << " of " << node.name;
    }
}

}  // namespace

TEST(Keywords, EveryEntryIsExplained) {
    for (const auto& table : keywordTables()) {
        std::set<std::string> seen;
        for (const auto& row : table.rows) {
            const std::string where = table.file + " " + table.place + ": " + row.name;
            EXPECT_FALSE(row.name.empty()) << where;
            EXPECT_FALSE(row.type.empty()) << where;
            EXPECT_FALSE(row.unit.empty()) << where;
            EXPECT_FALSE(row.defaultValue.empty()) << where;
            EXPECT_GE(row.meaning.size(), 6u) << where;
            EXPECT_TRUE(seen.insert(row.name).second) << "twice: " << where;
        }
        EXPECT_TRUE(!table.meaning.empty() || table.rows.size() == 1) << table.place;
    }
}

TEST(Keywords, PageIsNotStale) {
    std::ifstream file(PFEM_SOURCE_DIR "/doc/keywords.md");
    const std::string page((std::istreambuf_iterator<char>(file)), {});
    EXPECT_EQ(page, keywordPage()) << "make it anew: pfemMesh -help-keywords > doc/keywords.md";
}

TEST(Keywords, EveryFunctionTypeHasItsTable) {
    std::vector<std::string> documented;
    for (const auto& table : functionKeywords())
        if (!table.place.empty()) documented.push_back(table.place);
    EXPECT_EQ(documented, functionTypes());
}

TEST(Keywords, MeshDictIsComplete) {
    const auto dict = Dictionary::parse(
        "meshSize 0.1; bodies { a { type solid; material oil; vertices ((0 0) (1 0) (1 1) (0 1)); meshSize "
        "0.2; "
        "velocity (1 2); pattern checkerboard; cells (3 4); holes (); edges (arc 0 1 (0.5 -0.1)); "
        "patches { p { edges ((0 1)); } } } } "
        "walls { w { points ((0 0) (1 0)); closed no; moving no; meshSize 1; edges (); } } "
        "refinements { b { type box; min (0 0); max (1 1); meshSize 1; } c { type curve; points ((0 0) (1 0)); "
        "distance 1; "
        "meshSize 1; } s { type sphere; centre (0 0); radius 1; meshSize 1; } o { type sphere; origin (0 0); radius "
        "1; meshSize 1; } } holdSizes no;");
    readMeshDict(dict, {"oil"});
    expectDocumented(*dict.node(), names(meshKeywords()), {"a", "p", "w", "b", "c", "s", "o"});
    const auto file = Dictionary::parse(
        "meshFile \"a.msh\"; scale 1; cellArray x; bodies { a { type fluid; material oil; group g; meshSize 1; patches "
        "{ p { "
        "group h; } } } } walls { w { group i; moving no; meshSize 1; } }");
    readMeshDict(file, {"oil"});
    expectDocumented(*file.node(), names(meshKeywords()), {"a", "p", "w"});
}

TEST(Keywords, MeshDictInSpaceIsComplete) {
    const auto dict = Dictionary::parse(
        "dimension 3; meshSize 0.1; geometry { b { type box; name c; min (0 0 0); max (1 1 1); } "
        "y { type cylinder; point1 (0 0 0); point2 (0 0 1); radius 1; segments 24; } "
        "k { type cone; point1 (0 0 0); radius1 1; point2 (0 0 1); radius2 0; } s { type sphere; centre (0 0 0); "
        "radius 1; } "
        "o { type sphere; origin (0 0 0); radius 1; } f { type plane; point (0 0 0); normal (0 0 1); side 1; } "
        "d { type disk; origin (0 0 0); normal (0 0 1); radius 1; } "
        "e { type extrude; vertices ((0 0) (1 0) (1 1)); edges (arc 1 2 (1.1 0.5)); from 0; height 1; } "
        "r { type extrude; vertices ((0 0) (1 0) (1 1)); direction (0 0 1); } "
        "t { type extrude; vertices ((0 0) (1 0) (1 1)); axis y; angle 90; } } "
        "bodies { a { type solid; material oil; geometry c; subtract (y); intersect (s); meshSize 0.2; velocity (1 2 "
        "3); "
        "patches { p { faces (xMin); box (0 0 0) (1 1 1); } } } } "
        "walls { w { geometry c; open (zMax); fluid inside; moving no; } } "
        "refinements { x { type box; min (0 0 0); max (1 1 1); meshSize 1; } "
        "z { type sphere; centre (0 0 0); radius 1; meshSize 1; } u { type surface; geometry y; distance 1; meshSize "
        "1; } }");
    EXPECT_EQ(meshDimension(dict, ""), 3);
    readSpaceDict(dict, {"oil"}, "");
    auto documented = names(spaceMeshKeywords());
    documented.merge(names(meshKeywords()));
    const auto file = Dictionary::parse(
        "meshFile \"a.msh\"; scale 1; cellArray x; bodies { a { type fluid; material oil; group g; patches { p { group "
        "h; } "
        "} } } walls { w { group i; moving no; fluid inside; } }");
    readSpaceDict(file, {"oil"}, "");
    expectDocumented(*file.node(), documented, {"a", "p", "w"});
    expectDocumented(*dict.node(), documented,
                     {"a", "p", "w", "b", "y", "k", "s", "o", "f", "d", "e", "r", "t", "x", "z", "u"});
}

TEST(Keywords, SweepDictIsComplete) {
    const auto dict = Dictionary::parse(
        "method latinHypercube; samples 3; seed 2; mesh pfemMesh; command pfemFsiFoam; processors 1; slurm "
        "(\"--time=1\"); "
        "parameters { a { file f; entry e; values (1 2); } b { file f; entry d; range (1 2); scale log; count 3; } } "
        "results { c { function tip; file D; column D_x; value at; time 1; } }");
    readSweep(dict);
    expectDocumented(*dict.node(), names(sweepKeywords()), {"a", "b", "c", "parameters", "results"});
}

TEST(Keywords, ConstantIsComplete) {
    const auto materials = Dictionary::parse(
        "water { type newtonian; rho 1; mu 1; kappa 1; } mud { type bingham; rho 1; mu 1; tau0 1; m 1; }"
        "clay { type herschelBulkley; rho 1; k 1; n 0.5; tau0 1; } steel { type hypoelastic; rho 1; E 1; nu 0; }");
    readMaterials(materials);
    expectDocumented(*materials.node(), names(constantKeywords()), {"water", "mud", "clay", "steel"});
    const auto conditions = Dictionary::parse(
        "a { type slip; friction 0.004; } b { type clamped; } c { type symmetry; } d { type traction; traction (0 1 "
        "0); } e "
        "{ type noSlip; motion { velocity (1 0 0); omega 1; origin (0 0 0); } } f { type sideWalls; width 1; friction "
        "0.004; } g { type inlet; flowRate 1; profile expression; shape y; direction (1 0 0); start 1; stop 2; } h { "
        "type "
        "inlet; velocity 1; } i { type outlet; pressure 1; } j { type outlet; level 1; waveSpeed 1; } n { type "
        "damping; from (0 0 0); to (1 0 0); rate 1; exponent 2; velocity (0 0 0); } k { type slip; motion { "
        "displacement { type waveMaker; theory jonswap; maker piston; depth 1; height 0.1; period 1; ramp 1; start 1; "
        "gamma "
        "2; components 10; seed 2; gravity 9; scale (1 0 0); } } } l { type slip; motion { displacement { type "
        "waveMaker; "
        "theory focused; depth 1; height 0.1; period 1; focusTime 9; focusPlace 3; } } }");
    std::vector<Patch<2>> patches;
    for (const char* name : {"a", "b", "c", "d", "e", "g", "h", "i", "j", "k", "l"}) patches.push_back({name, {}});
    readBoundaryConditions<2>(conditions, patches);
    expectDocumented(*conditions.node(), names(conditionKeywords()),
                     {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "n", "FoamFile"});
}

TEST(Keywords, FunctionsAreComplete) {
    const auto dict =
        Dictionary::parse("p { type probes; fields (p); points ((0 0 0)); } m { type fieldMinMax; fields (p); }");
    for (const char* name : {"p", "m"}) {
        makeFunction<2>(dict.subDict(name), {name, "", "", 6, "0"});
        expectDocumented(*dict.subDict(name).node(), names(functionKeywords()), {});
    }
}
