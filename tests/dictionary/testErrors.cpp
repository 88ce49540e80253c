// Every message names the file and the line where the user has to look.

#include <gtest/gtest.h>

#include <functional>

#include "dictionary/dictionary.hpp"

using namespace pfem;

namespace {

using Read = std::function<void(const Dictionary&)>;

void expectError(const std::string& text, int line, const std::string& part, const Read& read = {}) {
    try {
        const Dictionary d = Dictionary::parse(text, "/case/system/controlDict");
        if (read) read(d);
        FAIL() << "no error: " << text;
    } catch (const UserError& error) {
        EXPECT_EQ(error.where().file, "/case/system/controlDict") << text;
        EXPECT_EQ(error.where().line, line) << text << '\n' << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << text << '\n' << error.what();
    }
}

template <class T>
Read get(const std::string& key) {
    return [key](const Dictionary& d) { d.get<T>(key); };
}

}  // namespace

TEST(Errors, missingSemicolon) {
    const std::string text = "startTime 0;\ndeltaT 0.001\nwriteControl adjustable;\nend 1;\n";
    expectError(text, 2, "Entry 'deltaT' has 2 excess tokens in stream\n\n    3(0.001 writeControl adjustable)",
                get<double>("deltaT"));
    expectError(text, 2, "missing ';' at the end of line 2 ?", get<double>("deltaT"));
    expectError(text, 3, "missing ';' before line 3 ?", get<std::string>("writeControl"));
    expectError(text, 3, "missing ';'", [](const Dictionary& d) { d.get("writeControl", "timeStep"); });
    expectError("a 1\n\nsub { b 1; }", 1, "Entry 'a' is not ended before '{': missing ';' ?");
    expectError("sub\n{\n a 1;\n b 2\n}\nc 1;", 4, "Entry 'b' is not ended before '}': missing ';' ?");
    expectError("a 1;\nb 2", 2, "Entry 'b' is not ended before the end of the file: missing ';' ?");
    expectError("a 1;\nb", 2, "Entry 'b' is not ended");
    expectError("a 1 2;", 1, "Entry 'a' has 1 excess tokens in stream", get<int>("a"));
}

TEST(Errors, brackets) {
    expectError("a (1 2;\nb 1;\nc 2;", 1, "Imbalanced brackets: '(' is not closed in entry 'a'");
    expectError("a 1 2);", 1, "Imbalanced brackets: ')' without '('");
    expectError("x 1;\na (1 2];", 2, "Imbalanced brackets: ']' without '['");
    expectError("a\n(\n (1 2\n);\n", 2, "Imbalanced brackets: '(' is not closed in entry 'a'");
    expectError("a [1 2;", 1, "'[' is not closed");
    expectError("x 1;\nsub {\n x 1;\n\n\n", 2, "'{' of 'sub' without its closing '}'");
    expectError("x 1;\n}\n", 2, "Unexpected '}' while reading dictionary entry");
    expectError("a\nword(1 2;", 2, "'(' without ')'");
}

TEST(Errors, unendedTexts) {
    expectError("a 1;\nb \"text\nmore\";", 2, "found '\\n' while reading string \"text\"");
    expectError("a 1;\nb \"text", 2, "without its closing quote");
    expectError("a 1;\n/* comment\n\n", 2, "Comment /* without its end");
    expectError("a 1;\nb #{ code\n\n", 2, "without its end #}");
    expectError("a 1;\nb ${name;\n\n", 2, "without its closing '}'");
    expectError("a 1;\nb #eval{ 1\n\n", 2, "without its closing '}'");
    expectError(std::string("a 1;\nb \0 2;", 11), 2, "not a text file");
    expectError("(1 2 3)", 1, "A keyword is expected, found punctuation '('");
}

TEST(Errors, patternsThatWouldTakeAllMemory) {
    expectError("x 1;\n\"a" + std::string(40, '+') + "\" 1;", 2, "is too large");
    expectError(
        "x 1;\n\"" + std::string(20, '(') + "a" +
            [] {
                std::string text;
                for (int i = 0; i < 20; ++i) text += ")+";
                return text;
            }() +
            "\" 1;",
        2, "is too large");
    EXPECT_EQ(Dictionary::parse("\"(a+)+b+c+d+.+\" 3;").get<int>("aabcdx"), 3);
}

TEST(Errors, types) {
    expectError("a 1;\nb abc;", 2, "Wrong token type - expected scalar value, found on line 2: word 'abc'",
                get<double>("b"));
    for (const char* bad : {"1.0abc", "1e", "1.2.3", "(1 2)", "nan", "inf", "-inf", "1e999", "1,5", "\"1\"", "{}"}) {
        expectError("x 1;\nb " + std::string(bad) + ";", 2,
                    bad[0] == '{'               ? ""
                    : bad == std::string("1,5") ? "excess"
                                                : "scalar",
                    get<double>("b"));
    }
    expectError("a;", 1, "found on line 1: end of entry", get<double>("a"));
    expectError("a 1.5;", 1, "expected integer value", get<int>("a"));
    expectError("a 3000000000;", 1, "expected integer value", get<int>("a"));
    expectError("a 99999999999999999999;", 1, "expected integer value", get<std::int64_t>("a"));
    expectError("a maybe;", 1, "expected bool", get<bool>("a"));
    expectError("a 2;", 1, "expected bool", get<bool>("a"));
    expectError("a 2;", 1, "expected word", get<std::string>("a"));
    expectError("a constant/foo;", 1, "excess", get<std::string>("a"));
    expectError("a (1 2);", 1, "vector of 3 components", get<Eigen::Vector3d>("a"));
    expectError("a (1 2 3 4);", 1, "vector of 3 components", get<Eigen::Vector3d>("a"));
    expectError("a\n(\n1\nx\n);", 4, "expected scalar value, found on line 4: word 'x'", get<std::vector<double>>("a"));
    expectError("a 1;", 1, "expected list", get<std::vector<double>>("a"));
    expectError("a 3(1 2);", 1, "list of 2 elements is announced as one of 3", get<std::vector<double>>("a"));
    expectError("a 1000000000000{0};", 1, "too long", get<std::vector<double>>("a"));
    expectError("a 99999999999999999999{0};", 1, "number of list elements", get<std::vector<double>>("a"));
    expectError("a 1; s { b 1; }", 1, "is a sub-dictionary, not a value", get<double>("s"));
    expectError("a 1;", 1, "is not a sub-dictionary", [](const Dictionary& d) { d.subDict("a"); });
    expectError("x 1;\nrho [0 1 0 0 0 0 0] 5;", 2,
                "Dimensions [0 1 0 0 0 0 0] (m) of entry 'rho' should be [1 -3 0 0 0 0 0] (kg m^-3)",
                [](const Dictionary& d) {
                    d.dimensioned("rho", {1, -3, 0, 0, 0, 0, 0});
                });
}

TEST(Errors, absentEntries) {
    const std::string text = "a 1;\ndeltat 1;\nsub\n{\n  x 1;\n}\n";
    expectError(text, 1,
                "Entry 'deltaT' not found in dictionary \"/case/system/controlDict\" (did you mean 'deltat' "
                "on line 2?)",
                get<double>("deltaT"));
    expectError(text, 4, "Entry 'y' not found in dictionary \"/case/system/controlDict.sub\"",
                [](const Dictionary& d) { d.subDict("sub").get<double>("y"); });
    expectError(text, 1, "Entry 'z' not found in dictionary \"/case/system/controlDict.none\"",
                [](const Dictionary& d) { d.subDictOrEmpty("none").get<double>("z"); });
    const Dictionary d = Dictionary::parse(text, "file");
    EXPECT_EQ(d.where().line, 1);
    EXPECT_EQ(d.subDict("sub").where().line, 4);
    EXPECT_EQ(d.subDict("sub").where().lastLine, 6);
    EXPECT_EQ(d.subDict("sub").name(), "file.sub");
    EXPECT_EQ(d.where("sub").line, 3);
    EXPECT_EQ(d.subDict("sub").where("x").line, 5);
}

TEST(Errors, macrosAndDirectives) {
    expectError("abc 1;\n\nb $abd;", 3,
                "Illegal dictionary entry or environment variable name \"abd\" (did you mean 'abc'?)\n"
                "Known dictionary entries: 1(abc)");
    expectError("a $a;", 1, "Illegal dictionary entry");
    expectError("a { $a; }", 1, "Illegal dictionary entry");
    expectError("a 1;\nb { $a; }", 2, "$a is not a dictionary");
    expectError("a 1;\nb #eval \"1+\";", 2, "Cannot evaluate \"1+\"");
    expectError("a 1;\nb #eval \"1/0\";", 2, "not a finite number");
    expectError("a 1;\nb #eval 3;", 2, "needs \"expression\"");
    expectError("a 1;\nb #codeStream { code #{ #}; };", 2, "#codeStream is not supported");
    expectError("a 1;\n#incldue \"x\"", 2, "did you mean 'include'?");
    expectError("a 1;\n#include \"nothingThere\"", 2, "cannot find file \"/case/system/nothingThere\"");
    expectError("a 1;\nb #include \"nothingThere\";", 2, "cannot find file");
    expectError("a 1;\n#includeEtc \"nothingThere\"", 2, "cannot find file \"nothingThere\" in $PFEM_ETC");
    expectError("a 1;\n#inputMode x", 2, "merge");
    expectError("a 1;\n#if on\nb 1;", 2, "#if without #endif");
    expectError("a 1;\n#if off\nb 1;", 2, "#if without #endif");
    expectError("a {\n#if on\nb 1;}", 2, "#if without #endif");
    expectError("a 1;\n#else\nb 1;", 2, "#else without #if");
    expectError("a 1;\n#if maybe\n#endif", 2, "expected bool");
    expectError("a 1;\n\"(x\" 1;", 2, "is not a regular expression");
    expectError("a 1;\n\"(x*)*\\1\" 1;", 2, "back references are not supported");
}
