// Files: #include and its relatives, and text that is meant to do harm.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "dictionary/dictionary.hpp"
#include "dictionary/function1.hpp"
#include "dictionary/overlay.hpp"
#include "dictionary/print.hpp"

using namespace pfem;
namespace fs = std::filesystem;

namespace {

class Includes : public testing::Test {
protected:
    Includes() : dir_(fs::temp_directory_path() / ("pfemIncludes" + std::to_string(getpid()))) {
        fs::create_directories(dir_ / "sub");
        setenv("PFEM_ETC", (dir_ / "etc").c_str(), 1);
        setenv("HOME", (dir_ / "home").c_str(), 1);
    }
    ~Includes() override { fs::remove_all(dir_); }

    fs::path write(const std::string& name, const std::string& text) {
        fs::create_directories((dir_ / name).parent_path());
        std::ofstream(dir_ / name) << text;
        return dir_ / name;
    }
    std::string expanded(const std::string& text) {
        std::string line = oneLine(Dictionary::read(write("main", text)));
        while (line.ends_with(' ')) line.pop_back();
        return line;
    }
    void expectError(const std::string& text, const std::string& file, int line, const std::string& part) {
        try {
            expanded(text);
            FAIL() << "no error: " << text;
        } catch (const UserError& error) {
            EXPECT_EQ(error.where().file, (dir_ / file).string());
            EXPECT_EQ(error.where().line, line) << error.what();
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }

    fs::path dir_;
};

}  // namespace

TEST_F(Includes, TextsThatStandForFiles) {
    const fs::path inner = write("sub/../common", "a 1;"), file = write("main", "#include \"common\"\nb $a;");
    EXPECT_EQ(oneLine(readWith({{fs::weakly_canonical(inner), "a 2;"}}, file)), "a 2; b 2; ");
    EXPECT_EQ(oneLine(readWith({{fs::weakly_canonical(file), "c 3;"}}, file)), "c 3; ");
    EXPECT_EQ(oneLine(Dictionary::read(file)), "a 1; b 1; ");
}

TEST_F(Includes, relativeToTheIncludingFile) {
    write("sub/a", "FoamFile { class dictionary; }\nx 1;\n#include \"b\"\n");
    write("sub/b", "y $x;");
    EXPECT_EQ(expanded("#include \"sub/a\"\nz $y;"), "x 1; y 1; z 1;");
    EXPECT_EQ(expanded("s {\n#include \"sub/a\"\n}"), "s { x 1; y 1; }");
    setenv("PFEM_TEST_DIR", (dir_ / "sub").c_str(), 1);
    EXPECT_EQ(expanded("x 5;\n#include \"$PFEM_TEST_DIR/b\"\n"), "x 5; y 5;");
    EXPECT_EQ(expanded("x 5; d sub;\n#include \"${d}/b\"\n"), "x 5; d sub; y 5;");
    write("sub/list", "(1 2 $x)");
    EXPECT_EQ(expanded("x 3; l #include \"sub/list\";"), "x 3; l ( 1 2 3 );");
    setenv("PFEM_CASE", dir_.c_str(), 1);
    write("constant/c", "q 1;");
    EXPECT_EQ(expanded("#include \"<constant>/c\"\n#include \"<case>/constant/c\""), "q 1;");
    unsetenv("PFEM_CASE");
    write("system/controlDict", "");
    EXPECT_EQ(expanded("s {\n#include \"<constant>/c\"\n}"), "s { q 1; }") << "the case of the file";
}

// Byte order marks of some editors, in the file itself and in those that it names; UTF-16 is told apart.
TEST_F(Includes, byteOrderMarks) {
    const std::string mark = "\xEF\xBB\xBF";
    write("marked", mark + "x 1;\n");
    EXPECT_EQ(expanded(mark + "#include \"marked\"\ny 2;"), "x 1; y 2;");
    write("table", mark + "((0 1) (1 3))");
    const auto f =
        readFunction1<double>(Dictionary::read(write("main", mark + "f { type tableFile; file \"table\"; }")), "f");
    EXPECT_EQ(f->value(0.5), 2);
    write("wide", std::string("\xFF\xFEx\0;\0", 6));
    expectError("#include \"wide\"", "main", 1, "UTF-16");
}

TEST_F(Includes, optionalAndEtc) {
    EXPECT_EQ(expanded("#includeIfPresent \"none\"\n#sinclude \"none\"\na 1;"), "a 1;");
    write("home/.pfem/caseDicts/c", "where home;");
    EXPECT_EQ(expanded("#includeEtc \"caseDicts/c\"\n"), "where home;");
    write("etc/caseDicts/c", "where etc;");
    EXPECT_EQ(expanded("#includeEtc \"caseDicts/c\"\n"), "where etc;");
    EXPECT_EQ(expanded("functions {\n#includeFunc residuals(p, U)\n}"), "functions { }");
    write("etc/caseDicts/postProcessing/residuals", "residuals { type residuals; }");
    EXPECT_EQ(expanded("functions {\n#includeFunc residuals(p, U)\n}"),
              "functions { residuals(p,U) { type residuals; fields ( p U ); } }");
    EXPECT_EQ(expanded("functions {\n#includeFunc residuals\n}"), "functions { residuals { type residuals; } }");
    write("mag", "type mag; field x; scale 1;");
    EXPECT_EQ(expanded("#includeFunc mag(U, scale=2)\n"),
              "mag(U,scale=2) { type mag; field U; scale 2; fields ( U ); }");
}

TEST_F(Includes, errorsNameTheIncludedFile) {
    write("sub/bad", "a 1;\nb 2 }");
    expectError("#include \"sub/bad\"", "sub/bad", 2, "missing ';'");
    expectError("x 1;\n#include \"sub\"", "main", 2, "is not a file");
    expectError("x 1;\n#include \"none\"", "main", 2, "cannot find file");
    write("sub/type", "\nvalue word;");
    const auto d = Dictionary::read(write("main", "#include \"sub/type\"\n"));
    EXPECT_EQ(d.where("value").file, (dir_ / "sub/type").string());
    EXPECT_EQ(d.where("value").line, 2);
    EXPECT_THROW(Dictionary::read(dir_ / "missing"), UserError);
    EXPECT_THROW(Dictionary::read(dir_), UserError);
}

TEST_F(Includes, cycles) {
    write("a", "#include \"sub/b\"\n");
    write("sub/b", "\n#include \"../a\"\n");
    expectError("#include \"a\"", "sub/b", 2, "includes itself");
    expectError("v #include \"main\";", "main", 1, "includes itself");
    for (int i = 0; i < 60; ++i)
        write("chain" + std::to_string(i), "#include \"chain" + std::to_string(i + 1) + "\"\n");
    EXPECT_THROW(Dictionary::read(dir_ / "chain0"), UserError);
    expectError("#include \"/dev/zero\"", "main", 1, "is not a file");
}

TEST(Hostile, growthIsLimited) {
    std::string lists = "a0 (x x x x x x x x x x);\n";
    std::string dicts = "a0 { x 1; }\n";
    std::string strings = "a0 \"xxxxxxxxxx\";\n";
    for (int i = 1; i < 20; ++i) {
        lists += fmt::format("a{0} ($a{1} $a{1} $a{1} $a{1} $a{1});\n", i, i - 1);
        dicts += fmt::format("a{0} {{ p {{ $a{1}; }} q {{ $a{1}; }} r {{ $a{1}; }} }}\n", i, i - 1);
        strings += fmt::format("a{0} \"$a{1}$a{1}$a{1}$a{1}\";\n", i, i - 1);
    }
    EXPECT_THROW(Dictionary::parse(lists), UserError);
    EXPECT_THROW(Dictionary::parse(dicts), UserError);
    EXPECT_THROW(Dictionary::parse(strings), UserError);
}

TEST(Hostile, depthIsLimited) {
    const auto repeated = [](const std::string& text, int n) {
        std::string all;
        for (int i = 0; i < n; ++i) all += text;
        return all;
    };
    EXPECT_THROW(Dictionary::parse(repeated("a {", 100000)), UserError);
    EXPECT_THROW(Dictionary::parse("a " + repeated("(", 100000) + ";"), UserError);
    EXPECT_THROW(Dictionary::parse("a " + repeated("( x {", 100000) + ";"), UserError);
    EXPECT_THROW(Dictionary::parse(repeated("a ({", 100000) + ";"), UserError);
    EXPECT_THROW(Dictionary::parse("a #eval \"" + repeated("(", 100000) + "\";"), UserError);
    EXPECT_THROW(Dictionary::parse("a #eval \"vector" + repeated("(", 9000) + "\";"), UserError);
    EXPECT_THROW(Dictionary::parse("a #eval \"vector(1,2,3)" + repeated("-", 9000) + "1\";"), UserError);
    EXPECT_THROW(Dictionary::parse("a #eval \"" + repeated("-", 9000) + "1+\";"), UserError);
    EXPECT_THROW(Dictionary::parse("a $" + repeated("a.", 100000) + ";"), UserError);
    EXPECT_THROW(Dictionary::parse("a " + repeated("${", 100000) + ";"), UserError);
    EXPECT_THROW(Dictionary::parse("a " + repeated("${", 1000) + repeated("}", 1000) + ";"), UserError);
    EXPECT_THROW(Dictionary::parse(repeated("#if on\n", 100000)), UserError);
    EXPECT_NO_THROW(Dictionary::parse("a " + repeated("(", 10000) + repeated(")", 10000) + ";"));
    EXPECT_THROW(Dictionary::parse("\"((((a{200}){200}){200}){200})\" 1;"), UserError);
    EXPECT_THROW(Dictionary::parse("\"" + repeated("(", 3000) + "\" 1;"), UserError);
    // copying a growing dictionary into itself, deeper and deeper
    EXPECT_THROW(Dictionary::parse("a { x 1; }\n" + repeated("b { c { $a; } } a { d { $b; } }\n", 300)), UserError);
    EXPECT_NO_THROW(Dictionary::parse("\"(a|aa)*b\" 1; " + repeated("x $aaaaaaaaaaaaaaaaaaaaaaaaaaaaab.c:-;", 0))
                        .found(std::string(200, 'a')));
}

TEST(Hostile, everyPrefixOfAFileIsReadOrRefused) {
    const std::string text =
        "FoamFile { class dictionary; }\n/* c */ a 1; // c\n\"b.*\" { c (1 2 [kg/m^3] { d \"x\\\"${a:-1}\"; "
        "}); }\n"
        "e ${a}; f { $b1; } g #eval{ 2*$a }; h #eval \"vector(1,2,$a)\"; i 3{0}; j #{ x #};\n"
        "#if $a > 0\nk 1;\n#else\nl 2;\n#endif\n#remove (a \"b.*\")\n#inputMode merge\nm -$e; n $:e; o "
        "\"${${a}}\";\n";
    for (std::size_t n = 0; n <= text.size(); ++n) {
        for (const char extra : {'\0', '{', '}', '(', ')', '[', ']', '"', '$', '#', ';', '\\', '/', '\n', '-', '<'}) {
            for (const std::string& rest : {std::string(), text.substr(n)}) {
                try {
                    const auto d = Dictionary::parse(text.substr(0, n) + extra + rest);
                    Dictionary::parse(oneLine(d));
                } catch (const UserError& error) {
                    EXPECT_GE(error.where().line, 1) << error.what();
                }
            }
        }
    }
}
