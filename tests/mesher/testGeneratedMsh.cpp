// A hundred .msh files of all forms; each is read, or refused for the damage that was done to it.

#include <gtest/gtest.h>

#include <random>

#include "mshCase.hpp"

using namespace pfem;
using namespace pfem::testing;

namespace {

constexpr unsigned files = 100;

MshForm randomForm(std::mt19937& random) {
    const auto yes = [&] { return random() % 2 == 0; };
    MshForm form;
    form.four = yes();
    form.binary = yes();
    form.parametric = yes();
    form.parts = yes() ? 1 : 2 + static_cast<int>(random() % 3);
    form.namesLast = yes();
    form.comments = yes();
    form.results = yes();
    form.mark = yes();
    form.windows = yes();
    form.height = yes() ? 0 : 1e-10;
    return form;
}

void replaceOnce(std::string& text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

/// Does something to the file; returns what must be said of it.
std::string damage(std::string& text, const MshForm& form, std::mt19937& random) {
    const std::string nodes = !form.four && form.parametric ? "ParametricNodes" : "Nodes";
    switch (random() % 6) {
        case 0:
            replaceOnce(text, form.four ? "4.1 " : "2.2 ", form.four ? "4.0 " : "2.0 ");
            return "save it as 2.2 or 4.1";
        case 1: {
            std::string end = form.results ? "$EndPeriodic" : form.namesLast ? "$EndPhysicalNames" : "$EndElements";
            text.erase(text.rfind(end));
            return end;
        }
        case 2:
            text += "$" + nodes + "\n0\n$End" + nodes + "\n";
            return form.binary ? "" : "a second $" + nodes;
        case 3:
            text += "rubbish\n";
            return "a section like $Nodes expected";
        case 4:
            replaceOnce(text, "$End" + nodes, "$EndNods");
            return "$End" + nodes;
        default:
            replaceOnce(text, "\"water\"", "\"wader\"");
            return "Unknown group of triangles water (did you mean 'wader'?)";
    }
}

TEST(GeneratedMsh, readOrRefusedForItsDamage) {
    const MshCase c;
    int damaged = 0;
    for (unsigned k = 0; k < files; ++k) {
        std::mt19937 random(k);
        const MshForm form = randomForm(random);
        SCOPED_TRACE(fmt::format(
            "file {}: four {} binary {} parametric {} parts {} namesLast {} comments {} results {} mark {} windows {}",
            k, form.four, form.binary, form.parametric, form.parts, form.namesLast, form.comments, form.results,
            form.mark, form.windows));
        std::string text = mshText(c.state, form);
        std::string expected;
        const bool sound = random() % 3 != 0;
        if (!sound) expected = damage(text, form, random), ++damaged;
        try {
            const auto mesh = takeMesh(c.description(), readMsh(c.folder.write("x.msh", text)));
            EXPECT_TRUE(sound) << expected;
            expectSame(c.state, mesh.state);
        } catch (const UserError& error) {
            EXPECT_FALSE(sound) << error.what();
            EXPECT_NE(std::string(error.what()).find(expected), std::string::npos)
                << error.what() << "\nexpected: " << expected;
            EXPECT_FALSE(error.where().file.empty());
        } catch (const std::exception& error) {
            ADD_FAILURE() << "not a user's error: " << error.what();
        }
    }
    EXPECT_GT(damaged, 20);
}

// Cut anywhere, or with any byte changed: a message or a mesh, nothing else.
TEST(GeneratedMsh, damageNeverCrashes) {
    const MshCase c;
    for (unsigned k = 0; k < 400; ++k) {
        std::mt19937 random(k);
        std::string text = mshText(c.state, randomForm(random));
        if (k % 2 == 0)
            text.resize(random() % text.size());
        else
            text[random() % text.size()] = static_cast<char>(random());
        try {
            takeMesh(c.description(), readMsh(c.folder.write("x.msh", text)));
        } catch (const UserError&) {
        }
    }
}

}  // namespace
