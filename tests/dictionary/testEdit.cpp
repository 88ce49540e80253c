// pfemDictionary -set, -add, -remove: only the entry changes.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "dictionary/dictionary.hpp"
#include "dictionary/edit.hpp"
#include "dictionary/print.hpp"

namespace pfem {

namespace {

const std::string text =
    "/* a 9; */\n"
    "FoamFile { version 2.0; }\n"
    "#include \"none;\" // a 8;\n"
    "a 1;          // one; }\n"
    "div(phi,U)  Gauss linear; b.c ( 1 (2 3) ); s \"x; } \\\" y\";\n"
    "sub // { not here\n"
    "{\n"
    "    g   (0 -9.81 0);   // gravity\n"
    "    deep { x 1; y { z 2; } }\n"
    "    \"(p|U)\" { tol 1; }\n"
    "    code #{ a 7; } #};\n"
    "    \n"
    "    // the end\n"
    "}\n"
    "$macro;\n"
    "a    2;\n"
    "sub { h 3; }\n"
    "empty {}\n"
    "// **** //\n";

/// `text` with one piece replaced.
std::string with(const std::string& old, const std::string& piece) {
    std::string changed = text;
    const auto at = changed.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return changed.replace(at, old.size(), piece);
}

using Path = std::vector<std::string>;

}  // namespace

TEST(Edit, SetChangesTheValueAlone) {
    EXPECT_EQ(setEntry(text, {"a"}, "5", "f"), with("a    2;", "a    5;")) << "the last one counts";
    EXPECT_EQ(setEntry(text, {"sub", "g"}, "(0 0 1)", "f"), with("(0 -9.81 0)", "(0 0 1)"));
    EXPECT_EQ(setEntry(text, {"sub", "deep", "y", "z"}, "-1e-3", "f"), with("z 2;", "z -1e-3;"));
    EXPECT_EQ(setEntry(text, {"sub", "h"}, "4", "f"), with("h 3;", "h 4;"));
    EXPECT_EQ(setEntry(text, {"sub", "(p|U)", "tol"}, "0", "f"), with("tol 1;", "tol 0;"));
    EXPECT_EQ(setEntry(text, {"div(phi,U)"}, "none", "f"), with("Gauss linear;", "none;"));
    EXPECT_EQ(setEntry(text, {"s"}, "\"z\"", "f"), with("\"x; } \\\" y\"", "\"z\""));
    EXPECT_EQ(setEntry(text, {"b.c"}, "$a", "f"), with("( 1 (2 3) )", "$a"));
    EXPECT_EQ(setEntry(text, {"sub", "code"}, "1", "f"), with("#{ a 7; } #}", "1"));
    EXPECT_EQ(setEntry(text, {"sub", "deep"}, "{ q 1; }", "f"), with("{ x 1; y { z 2; } }", "{ q 1; }"));
    EXPECT_EQ(setEntry(text, {"sub", "deep"}, "7", "f"), with("deep { x 1; y { z 2; } }", "deep 7;"));
}

TEST(Edit, SetAddsWhatIsMissing) {
    EXPECT_EQ(setEntry(text, {"new"}, "5", "f"), with("empty {}\n", "empty {}\nnew             5;\n"));
    EXPECT_EQ(setEntry(text, {"sub", "new"}, "5", "f"), with("h 3;", "h 3; new             5;"));
    EXPECT_EQ(setEntry(text, {"empty", "new"}, "5", "f"), with("empty {}", "empty {\n    new             5;\n}"));
    EXPECT_EQ(addEntry("a { b 1; // c\n}\n", {"a", "d"}, "{ e 1; }", "f"), "a { b 1; // c\nd { e 1; }\n}\n");
    EXPECT_EQ(addEntry("a\n{\n    b 1; // c\n}\n", {"a", "d"}, "2", "f"),
              "a\n{\n    b 1; // c\n    d               2;\n}\n");
    EXPECT_EQ(setEntry("", {"a"}, "1", "f"), "a               1;\n");
    EXPECT_THROW(addEntry(text, {"sub", "h"}, "1", "f"), UserError);
}

TEST(Edit, RemoveTakesTheLine) {
    EXPECT_EQ(removeEntry(text, {"sub", "g"}, "f"), with("    g   (0 -9.81 0);   // gravity\n", ""));
    EXPECT_EQ(removeEntry(text, {"sub", "deep", "x"}, "f"), with("x 1;", ""));
    EXPECT_EQ(removeEntry(removeEntry(text, {"a"}, "f"), {"empty"}, "f").find("a "), text.find("a 9;")) << "both";
    EXPECT_EQ(removeEntry("a 1;", {"a"}, "f"), "");
}

TEST(Edit, aByteOrderMarkStaysInFront) {
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_EQ(setEntry(mark + "a 1;\n", {"a"}, "2", "file"), mark + "a 2;\n");
    EXPECT_EQ(removeEntry(mark + "a 1;\nb 2;\n", {"b"}, "file"), mark + "a 1;\n");
}

TEST(Edit, MistakesAreNamed) {
    EXPECT_THROW(setEntry(text, {"none", "x"}, "1", "f"), UserError);
    EXPECT_THROW(setEntry(text, {"a", "x"}, "1", "f"), UserError) << "no dictionary";
    EXPECT_THROW(removeEntry(text, {"x"}, "f"), UserError);
    for (const char* bad : {"1; b 2", "(1 2", "{ a 1", "\"x", "}"})
        EXPECT_THROW(setEntry(text, {"a"}, bad, "f"), UserError) << bad;
    for (const char* broken : {"a {", "}", "\"", "a (", "#{", "/*", "a 1; b", "("}) {  // no hang, no crash
        try {
            setEntry(broken, {"x"}, "1", "f");
            removeEntry(broken, {"a"}, "f");
        } catch (const UserError&) {
        }
    }
}

// Every entry of a real dictionary, set to another value: the others stay as they are.
TEST(Edit, EveryEntryOfATutorial) {
    const std::string file = PFEM_SOURCE_DIR "/tutorials/damBreakElasticWall/system/pfemSolution";
    const Dictionary before = Dictionary::read(file);
    std::string all;
    {
        std::ifstream stream(file);
        all.assign(std::istreambuf_iterator<char>(stream), {});
    }
    int count = 0;
    for (const auto& part : before.keys()) {
        if (!before.isDict(part)) continue;
        for (const auto& key : before.subDict(part).keys()) {
            const Dictionary after = Dictionary::parse(setEntry(all, {part, key}, "17.5", file), file);
            EXPECT_EQ(after.subDict(part).get<double>(key), 17.5);
            for (const auto& other : before.subDict(part).keys())
                if (other != key) {
                    EXPECT_EQ(valueText(after.subDict(part), other), valueText(before.subDict(part), other));
                }
            ++count;
        }
    }
    EXPECT_GT(count, 15);
}

}  // namespace pfem
