// Macros, merging, conditions and #eval: what a text expands to.

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <vector>

#include "dictionary/dictionary.hpp"
#include "dictionary/expression.hpp"
#include "dictionary/print.hpp"

using namespace pfem;

namespace {

std::string expanded(const std::string& text) {
    std::string line = oneLine(Dictionary::parse(text));
    while (line.ends_with(' ')) line.pop_back();
    return line;
}

}  // namespace

TEST(Macros, scopes) {
    EXPECT_EQ(expanded("a 1; b $a; c ${a};"), "a 1; b 1; c 1;");
    EXPECT_EQ(expanded("a 1; s { a 2; b $a; c $:a; d $.a; e $..a; f $^a; g $../a; h $!a; }"),
              "a 1; s { a 2; b 2; c 1; d 2; e 1; f 1; g 1; h 1; }");
    EXPECT_EQ(expanded("s { t { x 1; } } a $s.t.x; b $!s/t/x;"), "s { t { x 1; } } a 1; b 1;");
    EXPECT_EQ(expanded("alpha.water 3; a $alpha.water;"), "alpha.water 3; a 3;");
    EXPECT_EQ(expanded("v (1 2 3); w ($v 4);"), "v ( 1 2 3 ); w ( ( 1 2 3 ) 4 );");
    EXPECT_EQ(expanded("a -2; b -$a; c 2; d (1 -$c);"), "a -2; b 2; c 2; d ( 1 -2 );");
}

TEST(Macros, patternsCountForWholeDictionariesOnly) {
    EXPECT_EQ(expanded("\"in.*\" { a 1; } s { $inlet; }"), "\"in.*\" { a 1; } s { a 1; }");
    EXPECT_EQ(expanded("x 5; p { \".*\" 3; a $x; }"), "x 5; p { \".*\" 3; a 5; }");
    EXPECT_THROW(expanded("\"in.*\" 3; a $inlet;"), UserError);
}

TEST(Macros, environmentAndDefaults) {
    setenv("PFEM_TEST_MACRO", "1 two", 1);
    EXPECT_EQ(expanded("a $PFEM_TEST_MACRO; b \"$PFEM_TEST_MACRO\";"), "a 1 two; b \"$PFEM_TEST_MACRO\";");
    EXPECT_EQ(Dictionary::parse("b \"x $PFEM_TEST_MACRO\";").get<std::string>("b"), "x 1 two");
    EXPECT_EQ(expanded("a ${missing:-42}; b ${a:-1}; c ${a:+7};"), "a 42; b 42; c 7;");
    EXPECT_EQ(Dictionary::parse("n 5; b \"${x:-y} $n.txt $5\";").get<std::string>("b"), "y 5.txt $5");
    EXPECT_EQ(expanded("n key; $n 3; m n; b ${${m}};"), "n key; key 3; m n; b key;");
}

TEST(Macros, dictionaries) {
    EXPECT_EQ(expanded("p { tol 1; relTol 0.1; s { a 1; } } pFinal { $p; relTol 0; s { b 2; } }"),
              "p { tol 1; relTol 0.1; s { a 1; } } pFinal { tol 1; relTol 0; s { a 1; b 2; } }");
    EXPECT_EQ(expanded("p { a 1; } q { $p\n b 2; }"), "p { a 1; } q { a 1; b 2; }");
    EXPECT_EQ(expanded("d Gauss multi { U linear; };"), "d Gauss multi { U linear; };");
    EXPECT_EQ(expanded("p { a 1; } q $p; l ( $p );"), "p { a 1; } q { a 1; } l ( { a 1; } );");
    EXPECT_EQ(expanded("s { a 1; } s { b 2; } x 1; x 2;"), "s { a 1; b 2; } x 2;");
    EXPECT_EQ(expanded("a 1; a { b 1; } c { d 1; } c 2;"), "a { b 1; } c 2;");
}

TEST(Macros, copiesAreIndependent) {
    EXPECT_EQ(expanded("p { s { a 1; } } q $p; q { s { a 2; } } r { $p; }"),
              "p { s { a 1; } } q { s { a 2; } } r { s { a 1; } }");
}

TEST(Macros, conditions) {
    EXPECT_EQ(expanded("a 3;\n#if $a\nb 1;\n#else\nb 2;\n#endif\nc 1;"), "a 3; b 1; c 1;");
    EXPECT_EQ(expanded("#if off\nb 1;\n#if on\nx 1;\n#else\ny 1;\n#endif\n#else\nb 2;\n#endif\nc 1;"), "b 2; c 1;");
    EXPECT_EQ(expanded("a 3;\n#if $a > 2 && $a < 5\nb 1;\n#endif"), "a 3; b 1;");
    EXPECT_EQ(expanded("a 3;\n#if #eval{ $a > 5 }\nb 1;\n#endif"), "a 3;");
    EXPECT_EQ(expanded("m air;\n#ifeq $m air\nb 1;\n#else\nb 2;\n#endif"), "m air; b 1;");
    EXPECT_EQ(expanded("s {\n#ifeq 1.0 1\nb 1;\n#endif\n}"), "s { b 1; }");
}

TEST(Macros, removeAndInputMode) {
    EXPECT_EQ(expanded("a 1; b1 2; b2 3; c 4;\n#remove a\n#remove (\"b.*\" d)\n"), "c 4;");
    EXPECT_EQ(expanded("#inputMode protect\na 1; a 2;\n#inputMode overwrite\ns {a 1;} s {b 1;}"), "a 1; s { b 1; }");
    EXPECT_THROW(expanded("#inputMode error\na 1; a 2;"), UserError);
}

TEST(Print, styleAndRoundTrip) {
    const std::string text =
        "FoamFile { class dictionary; }\n g (0 -9.81 0); rho [kg/m^3] 1000; n 3{0}; empty; \"(a|b)\" \"x "
        "\\\"y\";\n"
        "aVeryLongKeywordIndeed 1; sub { code #{ a; #}; list ( { a 1; } b { c 2; } ); }";
    std::ostringstream first;
    print(first, Dictionary::parse(text));
    EXPECT_EQ(first.str(),
              "FoamFile\n{\n    class           dictionary;\n}\n"
              "g               ( 0 -9.81 0 );\n"
              "rho             [ kg / m^3 ] 1000;\n"
              "n               3{ 0 };\n"
              "empty;\n"
              "\"(a|b)\"         \"x \\\"y\";\n"
              "aVeryLongKeywordIndeed 1;\n"
              "sub\n{\n    code            #{ a; #};\n    list            ( { a 1; } b { c 2; } );\n}\n");
    std::ostringstream second;
    print(second, Dictionary::parse(first.str()));
    EXPECT_EQ(second.str(), first.str());
}

TEST(Eval, scalars) {
    EXPECT_EQ(expanded("a -2; b #eval \"3-$a\"; c #eval{ sin(pi()/2) }; d #calc \"sqr(3)\";"), "a -2; b 5; c 1; d 9;");
    EXPECT_EQ(expanded("b #eval #{ 1 + 2 #}; c #eval \"${x:-4}/8\"; d (#eval \"1+1\" 3);"), "b 3; c 0.5; d ( 2 3 );");
    EXPECT_EQ(expanded("a 1; b #eval{ $a > 0 ? 10 : 20 }; c #eval \"degToRad(180)/pi\";"), "a 1; b 10; c 1;");
    for (const char* bad : {"1/0", "log(-1)", "", "1+", "nope", "nope(1)", "1,2", "((1)"}) {
        EXPECT_THROW(evaluateScalar(bad, {}), UserError) << bad;
    }
}

TEST(Eval, vectors) {
    EXPECT_EQ(expanded("v (1 -2 -3); w #eval \"2*$v + vector(1,0,0)\"; n #eval \"mag(vector(3,4,0))\";"),
              "v ( 1 -2 -3 ); w ( 3 -4 -6 ); n 5;");
    EXPECT_EQ(expanded("a #eval{ (1 0 0) ^ (0 1 0) }; b #eval{ (1 2 3) & (4 5 6) };"), "a ( 0 0 1 ); b 32;");
    EXPECT_EQ(expanded("a #eval{ -(1 2 3)/2 }; b #eval{ (sin(0) 1+1 -2) };"), "a ( -0.5 -1 -1.5 ); b ( 0 2 -2 );");
    for (const char* bad : {"(1 2 3) + 1", "(1 2 3)*(1 2 3)", "(1 2)", "vector(1,2)", "(1 2 3", "(1 2 3) x"}) {
        EXPECT_THROW(evaluateVector(bad, {}), UserError) << bad;
    }
}

TEST(Eval, expressionOfVariables) {
    const Expression f("x^2 + sin(pi*t)", {"x", "t"}, {});
    const std::vector<Expression> copies = {f};
    EXPECT_DOUBLE_EQ(f({3, 0.5}), 10);
    EXPECT_DOUBLE_EQ(copies[0]({2, 0}), 4);
    EXPECT_THROW(Expression("1/x", {"x"}, {})({0}), UserError);
}
