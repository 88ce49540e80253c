// Gmsh's binary files, byte by byte as its manual says: their text is the one that Gmsh would have written.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <sstream>

#include "base/error.hpp"
#include "mesher/mshBinary.hpp"

using namespace pfem;

namespace {

/// Appends words, or the bytes of int (32 bits), std::uint64_t and double.
struct Bytes {
    std::string content;
    Bytes& operator<<(const char* text) {
        content += text;
        return *this;
    }
    template <class T>
    Bytes& operator<<(T value) {
        static_assert(std::is_same_v<T, int> || std::is_same_v<T, std::uint64_t> || std::is_same_v<T, double>);
        content.append(reinterpret_cast<const char*>(&value), sizeof(T));
        return *this;
    }
};

std::uint64_t operator""_u(unsigned long long n) { return n; }

/// A triangle "w" with one edge "floor".
std::string two() {
    Bytes b;
    b << "$MeshFormat\n2.2 1 8\n"
      << 1 << "\n$EndMeshFormat\n$PhysicalNames\n2\n1 2 \"floor\"\n2 1 \"w\"\n$EndPhysicalNames\n$Nodes\n3\n";
    b << 1 << 0.0 << 0.0 << 0.0 << 2 << 1.0 << 0.0 << 0.0 << 3 << 0.25 << 0.1 << 0.0 << "\n$EndNodes\n$Elements\n2\n";
    b << 1 << 1 << 2 << 1 << 2 << 7 << 1 << 2;  // type, elements, tags; number, tags, nodes
    b << 2 << 1 << 2 << 2 << 1 << 9 << 1 << 2 << 3;
    b << "\n$EndElements\n$Periodic\n" << 0_u << "\n$EndPeriodic\n";
    return b.content;
}
const char* textOfTwo =
    "$MeshFormat 2.2 0 8 $EndMeshFormat $PhysicalNames 2 1 2 \"floor\" 2 1 \"w\" $EndPhysicalNames "
    "$Nodes 3 1 0 0 0 2 1 0 0 3 0.25 0.1 0 $EndNodes $Elements 2 1 1 2 2 7 1 2 2 2 2 1 9 1 2 3 $EndElements $Periodic "
    "$EndPeriodic";

/// The same in 4.1, with a point, places on the curve, and empty lists.
std::string four() {
    Bytes b;
    b << "$MeshFormat\n4.1 1 8\n" << 1 << "\n$EndMeshFormat\n$Entities\n" << 1_u << 1_u << 1_u << 0_u;
    b << 5 << 0.0 << 0.0 << 0.0 << 0_u;
    b << 7 << 0.0 << 0.0 << 0.0 << 1.0 << 0.0 << 0.0 << 1_u << 2 << 2_u << 5 << -5;
    b << 9 << 0.0 << 0.0 << 0.0 << 1.0 << 1.0 << 0.0 << 1_u << 1 << 1_u << 7 << "\n$EndEntities\n";
    b << "$Nodes\n" << 2_u << 3_u << 1_u << 3_u;
    b << 1 << 7 << 1 << 2_u << 1_u << 2_u << 0.0 << 0.0 << 0.0 << 0.5 << 1.0 << 0.0 << 0.0 << 0.75;
    b << 2 << 9 << 0 << 1_u << 3_u << 0.25 << 0.1 << 0.0 << "\n$EndNodes\n";
    b << "$Elements\n" << 2_u << 2_u << 1_u << 2_u << 1 << 7 << 1 << 1_u << 1_u << 1_u << 2_u;
    b << 2 << 9 << 2 << 1_u << 2_u << 1_u << 2_u << 3_u << "\n$EndElements\n";
    return b.content;
}
const char* textOfFour =
    "$MeshFormat 4.1 0 8 $EndMeshFormat $Entities 1 1 1 0 5 0 0 0 0 7 0 0 0 1 0 0 1 2 2 5 -5 9 0 0 0 1 1 0 1 1 1 7 "
    "$EndEntities "
    "$Nodes 2 3 1 3 1 7 1 2 1 2 0 0 0 0.5 1 0 0 0.75 2 9 0 1 3 0.25 0.1 0 $EndNodes "
    "$Elements 2 2 1 2 1 7 1 1 1 1 2 2 9 2 1 2 1 2 3 $EndElements";

std::string words(const std::string& text) {
    std::istringstream stream(text);
    std::string all, word;
    while (stream >> word) all += (all.empty() ? "" : " ") + word;
    return all;
}

std::string messageOf(const std::string& content) {
    try {
        textOfBinaryMsh(content, "x.msh");
    } catch (const UserError& error) {
        EXPECT_EQ(error.where().file, "x.msh");
        return error.what();
    }
    return "";
}

TEST(MshBinary, TextIsThatOfGmsh) {
    EXPECT_TRUE(isBinaryMsh(two()));
    EXPECT_TRUE(isBinaryMsh(four()));
    EXPECT_FALSE(isBinaryMsh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"));
    EXPECT_FALSE(isBinaryMsh(""));
    EXPECT_FALSE(isBinaryMsh("$MeshFormat"));
    EXPECT_EQ(words(textOfBinaryMsh(two(), "x.msh")), textOfTwo);
    EXPECT_EQ(words(textOfBinaryMsh(four(), "x.msh")), textOfFour);
}

TEST(MshBinary, WhatCannotBeReadIsNamed) {
    const auto with = [](std::string content, const std::string& from, const std::string& to) {
        return content.replace(content.find(from), from.size(), to);
    };
    EXPECT_NE(messageOf(with(two(), "2.2 1 8", "2.1 1 8")).find("save it as 2.2 or 4.1"), std::string::npos);
    EXPECT_NE(messageOf(with(four(), "4.1 1 8", "4.1 1 4")).find("not 8 bytes"), std::string::npos);
    EXPECT_NE(messageOf(with(two(), std::string("\1\0\0\0", 4), std::string("\0\0\0\1", 4))).find("other order"),
              std::string::npos);
    EXPECT_NE(messageOf(with(two(), "$Nodes\n3", "$Nodes\n2")).find("$EndNodes expected"), std::string::npos);
    EXPECT_NE(messageOf(with(two(), "$Nodes\n3", "$Nodes\n999999999999")).find("no number of things"),
              std::string::npos);
    EXPECT_NE(messageOf(with(two(), "$EndPeriodic", "$")).find("without $EndPeriodic"), std::string::npos);
}

/// Never more than a message, and never without one where an end is missing.
TEST(MshBinary, EveryCutAndEveryFlippedByteIsSafe) {
    for (const std::string& whole : {two(), four()}) {
        for (std::size_t n = whole.find("$EndMeshFormat"); n < whole.size(); ++n) {
            const std::string cut = whole.substr(0, n);
            const bool betweenSections = messageOf(cut).empty();
            if (betweenSections) {
                EXPECT_EQ(words(textOfBinaryMsh(whole, "x")).find(words(textOfBinaryMsh(cut, "x"))), 0u) << n;
            }
            std::string flipped = whole;
            for (const int bits : {1, 0x80, 0xff}) {
                flipped[n] = static_cast<char>(whole[n] ^ bits);
                messageOf(flipped);
            }
        }
    }
}

}  // namespace
