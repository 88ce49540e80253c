// Typed reading of the forms of the grammar.

#include <gtest/gtest.h>

#include <sstream>

#include "dictionary/dictionary.hpp"
#include "dictionary/flatEntries.hpp"

using namespace pfem;

TEST(Read, scalarsWordsAndStrings) {
    const auto d = Dictionary::parse(R"(
        FoamFile { version 2.0; format ascii; class dictionary; object test; }
        // a comment ; with { braces
        a 1; b -1.5e-3; c .5; /* more
        lines */ big 12345678901; word div(phi,U); text "a \"b\" c"; e +2;
        yes_ yes; off_ off; t_ t; none_ none;
        empty;
    )");
    EXPECT_EQ(d.get<int>("a"), 1);
    EXPECT_EQ(d.get<double>("a"), 1.0);
    EXPECT_EQ(d.get<double>("b"), -1.5e-3);
    EXPECT_EQ(d.get<double>("c"), 0.5);
    EXPECT_EQ(d.get<double>("e"), 2.0);
    EXPECT_EQ(d.get<std::int64_t>("big"), 12345678901);
    EXPECT_EQ(d.get<std::string>("word"), "div(phi,U)");
    EXPECT_EQ(d.get<std::string>("text"), "a \"b\" c");
    EXPECT_TRUE(d.get<bool>("yes_"));
    EXPECT_FALSE(d.get<bool>("off_"));
    EXPECT_TRUE(d.get<bool>("t_"));
    EXPECT_FALSE(d.get<bool>("none_"));
    EXPECT_TRUE(d.found("empty"));
    EXPECT_EQ(d.keys().front(), "a") << "the header is no entry";
    EXPECT_EQ(d.get("absent", 7), 7);
    EXPECT_EQ(d.get("absent", "word"), "word");
}

TEST(Read, vectorsAndLists) {
    const auto d = Dictionary::parse(R"(
        g (0 -9.81 0); a (1 2 3); counted 3(1 2 3); uniform 4{0.5}; typed List<scalar> 2(1 2); none ();
        words (air "water"); vectors ((0 0 0) (1 1 1)); table ((0 1) (2 3 4)); same 2{(1 2 3)};
    )");
    EXPECT_EQ(d.get<Eigen::Vector3d>("g"), Eigen::Vector3d(0, -9.81, 0));
    EXPECT_EQ(d.get<std::vector<double>>("a"), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(d.get<std::vector<int>>("counted"), (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(d.get<std::vector<double>>("uniform"), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
    EXPECT_EQ(d.get<std::vector<double>>("typed"), (std::vector<double>{1, 2}));
    EXPECT_TRUE(d.get<std::vector<double>>("none").empty());
    EXPECT_EQ(d.get<std::vector<std::string>>("words"), (std::vector<std::string>{"air", "water"}));
    EXPECT_EQ(d.get<std::vector<Eigen::Vector3d>>("vectors").at(1), Eigen::Vector3d(1, 1, 1));
    EXPECT_EQ(d.get<std::vector<std::vector<double>>>("table").at(1), (std::vector<double>{2, 3, 4}));
    EXPECT_EQ(d.get<std::vector<Eigen::Vector3d>>("same").at(1), Eigen::Vector3d(1, 2, 3));
}

TEST(Read, listsOfDictionaries) {
    const auto d = Dictionary::parse(R"(
        outer 5;
        plain ({ type a; } { type b; });
        regions ( boxToCell { box (0 0 0) (1 1 1); } other { x $outer; } );
        both { one { v 1; } two { v 2; } }
    )");
    EXPECT_EQ(d.dictList("plain").at(1).get<std::string>("type"), "b");
    const auto regions = d.dictList("regions");
    ASSERT_EQ(regions.size(), 2u);
    EXPECT_EQ(regions[0].keyword(), "boxToCell");
    EXPECT_EQ(regions[1].get<int>("x"), 5);
    TokenReader box = regions[0].reader("box");
    EXPECT_EQ(box.read<Eigen::Vector3d>(), Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(box.read<Eigen::Vector3d>(), Eigen::Vector3d(1, 1, 1));
    EXPECT_TRUE(box.atEnd());
    EXPECT_EQ(d.dictList("both").at(1).keyword(), "two");
}

TEST(Read, mixedLists) {
    const auto d = Dictionary::parse("table ((0 (0 0 0)) (0.1 (1 0 0)));");
    std::vector<double> times;
    TokenReader table = d.reader("table");
    table.list([&] {
        table.open();
        times.push_back(table.read<double>());
        table.read<Eigen::Vector3d>();
        table.close();
    });
    table.end();
    EXPECT_EQ(times, (std::vector<double>{0, 0.1}));
}

TEST(Read, dimensioned) {
    const std::array<double, 7> density{1, -3, 0, 0, 0, 0, 0};
    const auto d = Dictionary::parse(R"(
        a 1000; b [1 -3 0 0 0 0 0] 1000; c rho [1 -3 0 0 0 0 0] 1000; d [kg m^-3] 1000; e [kg/m^3] 1000;
        f [1 -3 0 0 0] 1000; g [N.s^2/m^4] 1000; h [kg*(m m^2)^-1] 1000; i [] 1000;
        wrong [0 1 0 0 0 0 0] 1000; unknown [kg/furlong^3] 1000; six [1 2 3 4 5 6] 1;
    )");
    for (const char* key : {"a", "b", "c", "d", "e", "f", "g", "h"}) {
        EXPECT_EQ(d.dimensioned(key, density), 1000) << key;
    }
    EXPECT_EQ(d.dimensioned("absent", density, 2), 2);
    EXPECT_EQ(d.dimensioned("i", {}), 1000);
    for (const char* key : {"wrong", "unknown", "six", "i"}) {
        EXPECT_THROW(d.dimensioned(key, density), UserError) << key;
    }
}

TEST(Read, regexKeys) {
    const auto d = Dictionary::parse(R"(
        ".*" { tolerance 1; } "(p|U).*" { tolerance 2; } "p.*" { tolerance 3; } p { tolerance 4; }
        "(?i)FOO" { tolerance 5; } "plain" 1;
    )");
    const auto tolerance = [&](const char* key) { return d.subDict(key).get<int>("tolerance"); };
    EXPECT_EQ(tolerance("p"), 4);
    EXPECT_EQ(tolerance("pFinal"), 3);
    EXPECT_EQ(tolerance("UFinal"), 2);
    EXPECT_EQ(tolerance("k"), 1);
    EXPECT_EQ(tolerance("foo"), 5);
    EXPECT_EQ(d.keys(), (std::vector<std::string>{"p", "plain"}));
}

TEST(Read, choice) {
    const auto d = Dictionary::parse("writeControl sometimes; good runTime;");
    const std::vector<std::string> valid{"timeStep", "runTime", "adjustable"};
    EXPECT_EQ(d.choice("good", valid), "runTime");
    EXPECT_EQ(d.choice("absent", valid, "timeStep"), "timeStep");
    try {
        d.choice("writeControl", valid);
        FAIL();
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("3\n(\nadjustable\nrunTime\ntimeStep\n)"), std::string::npos);
    }
}

TEST(Read, whatMacrosTakeIsUsed) {
    const auto d = Dictionary::parse(R"(
        L 2;
        H 3;
        size { depth 0.5; rest 1; }
        common { tolerance 1; }
        spare { tolerance 1; }
        length $L;
        height #eval "2*$H";
        depth $size.depth;
        p { $common; }
    )",
                                     "system/meshDict");
    for (const auto& key : {"length", "height", "depth"}) d.get<double>(key);
    d.subDict("p").get<double>("tolerance");
    std::ostringstream out;
    warnUnused(d, out);
    EXPECT_EQ(out.str(), "--> PFEM Warning: entry 'spare' in system/meshDict:6 is not used\n");
}

TEST(Read, unusedEntries) {
    const auto d = Dictionary::parse(R"(
        FoamFile { class dictionary; }
        deltaT 1;
        maxC0 3;
        sub { used 1; toleranse 2; }
        functions { a { x 1; } }
        list ( one { read 1; ignored 2; } );
        ".*" 5;
    )",
                                     "system/controlDict");
    d.get<double>("deltaT");
    d.get("maxCo", 1.0);  // finds the pattern
    d.subDict("sub").get<int>("used");
    d.subDict("sub").get("tolerance", 1.0);
    d.dictList("list").at(0).get<int>("read");
    std::ostringstream out;
    warnUnused(d, out);
    EXPECT_EQ(out.str(),
              "--> PFEM Warning: entry 'maxC0' in system/controlDict:4 is not used (did you mean 'maxCo'?)\n"
              "--> PFEM Warning: entry 'toleranse' in system/controlDict:5 is not used (did you mean "
              "'tolerance'?)\n"
              "--> PFEM Warning: entry 'functions' in system/controlDict:6 is not used\n"
              "--> PFEM Warning: entry 'ignored' in system/controlDict:7 is not used\n");
}

TEST(Read, flatEntriesOfAListAreThoseOfBraces) {
    const std::string body = "a { type x; deep { y (1 2); } } b { z 3; }";
    const auto braces = flatEntries(Dictionary::parse("functions { " + body + " }"));
    EXPECT_EQ(flatEntries(Dictionary::parse("functions ( " + body + " );")), braces);
    EXPECT_EQ(braces.at("functions.a.deep.y"), "( 1 2 )");
    EXPECT_EQ(flatEntries(Dictionary::parse("f ( a { x 1; } 3 );")).at("f"), "( a { x 1; } 3 )");
    EXPECT_EQ(flatEntries(Dictionary::parse("f ( a { } );")).at("f"), "( a { } )");
    EXPECT_EQ(flatEntries(Dictionary::parse("f ( );")).at("f"), "( )");
}
