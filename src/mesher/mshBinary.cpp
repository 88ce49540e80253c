#include "mesher/mshBinary.hpp"

#include <array>
#include <iterator>
#include <map>

#include "mesher/mshBytes.hpp"

namespace pfem {

namespace {

/// The line of $MeshFormat: version, kind and size of the numbers.
std::string formatLine(const std::string& content) {
    const std::string head = "$MeshFormat";
    auto begin = content.find(head);
    while (begin != std::string::npos && begin > 0 && content[begin - 1] != '\n') begin = content.find(head, begin + 1);
    const auto end = content.find('\n', begin);
    if (begin == std::string::npos || end == std::string::npos) return "";
    return content.substr(end + 1, content.find('\n', end + 1) - end - 1);
}

/// Nodes of an element of Gmsh's types; the text's reader says which of them a mesh may have.
const std::map<int, std::size_t> nodesOf{{15, 1}, {1, 2}, {2, 3}, {8, 3}, {3, 4}, {9, 6}, {4, 4}, {11, 10}};

class BinaryMsh {
public:
    BinaryMsh(const std::string& content, const std::string& name) : bytes_(content, name) {}

    std::string text() {
        while (!bytes_.atEnd()) section(bytes_.line());
        return std::move(text_);
    }

private:
    void format() {
        const std::string format = bytes_.line(), version = format.substr(0, 3);
        new_ = version == "4.1";
        if (!new_ && version != "2.2") bytes_.fail(fmt::format("its format is {}: save it as 2.2 or 4.1", version));
        if (format.substr(3, 4) != " 1 8")
            bytes_.fail("its numbers have not 8 bytes: save it as text (Mesh.Binary = 0)");
        if (bytes_.take<std::int32_t>() != 1)
            bytes_.fail("its bytes are in the other order: save it as text (Mesh.Binary = 0)");
        put("{} 0 8\n", version);
        known_ = true;
    }

    void section(const std::string& head) {
        if (head.empty()) return;
        if (head[0] != '$') bytes_.fail(fmt::format("a section like $Nodes expected before byte {}", bytes_.at()));
        const std::string name = head.substr(1), end = "$End" + name;
        put("{}\n", head);
        if (name == "MeshFormat")
            format();
        else if (name == "PhysicalNames")
            put("{}", bytes_.before(end));
        else if (name == "Entities" && new_)
            entities();
        else if (name == "PartitionedEntities" && new_)
            partitionedEntities();
        else if (!known_ && (name == "Nodes" || name == "ParametricNodes" || name == "Elements"))
            bytes_.fail(head + " comes before $MeshFormat");
        else if (name == "Nodes")
            new_ ? nodes4() : nodes2(false);
        else if (name == "ParametricNodes" && !new_)
            nodes2(true);
        else if (name == "Elements")
            new_ ? elements4() : elements2();
        else
            bytes_.before(end);
        bytes_.expect(end);
        put("{}\n", end);
    }

    void entities() {
        const auto counts = copyCounts();
        for (std::size_t dimension = 0; dimension < counts.size(); ++dimension)
            for (std::size_t k = 0; k < counts[dimension]; ++k) {
                copy<std::int32_t>(1);  // its tag
                entity(dimension);
            }
    }

    void partitionedEntities() {
        put("{}\n", bytes_.takeCount());  // how many parts
        const std::size_t ghosts = bytes_.takeCount();
        put("{}\n", ghosts);
        for (std::size_t k = 0; k < ghosts; ++k) {
            copy<std::int32_t>(2);
            put("\n");
        }
        const auto counts = copyCounts();
        for (std::size_t dimension = 0; dimension < counts.size(); ++dimension)
            for (std::size_t k = 0; k < counts[dimension]; ++k) {
                copy<std::int32_t>(3);  // its tag; dimension and tag of what it is a part of
                copyList();             // the parts
                entity(dimension);
            }
    }

    /// Place, groups and boundary of an entity.
    void entity(std::size_t dimension) {
        copy<double>(dimension == 0 ? 3 : 6);
        copyList();
        if (dimension > 0) copyList();
        put("\n");
    }

    /// `parametric`: dimension and tag of the node's entity follow, and its places on a curve or a surface.
    void nodes2(bool parametric) {
        for (std::size_t n = copyCountLine(); n > 0; --n) {
            copy<std::int32_t>(1);
            copy<double>(3);
            if (parametric) {
                const auto dimension = bytes_.take<std::int32_t>(), entity = bytes_.take<std::int32_t>();
                put("{} {} ", dimension, entity);
                copy<double>(dimension == 1 || dimension == 2 ? static_cast<std::size_t>(dimension) : 0);
            }
            put("\n");
        }
    }

    void nodes4() {
        const std::size_t blocks = copyCounts()[0];
        for (std::size_t b = 0; b < blocks; ++b) {
            const auto [dimension, entity, parametric, n] = copyBlock();
            for (std::size_t k = 0; k < n; ++k) put("{}\n", bytes_.take<std::uint64_t>());
            for (std::size_t k = 0; k < n; ++k) {
                copy<double>(parametric && dimension > 0 ? 3 + static_cast<std::size_t>(dimension) : 3);
                put("\n");
            }
        }
    }

    void elements2() {
        for (std::size_t left = copyCountLine(); left > 0;) {
            const auto type = bytes_.take<std::int32_t>(), inBlock = bytes_.take<std::int32_t>(),
                       tags = bytes_.take<std::int32_t>();
            if (inBlock <= 0 || static_cast<std::size_t>(inBlock) > left || tags < 0)
                bytes_.fail(fmt::format("$Elements is damaged at byte {}", bytes_.at()));
            for (int k = 0; k < inBlock; ++k) {
                copy<std::int32_t>(1);
                put("{} {} ", type, tags);
                copy<std::int32_t>(static_cast<std::size_t>(tags) + nodes(type));
                put("\n");
            }
            left -= static_cast<std::size_t>(inBlock);
        }
    }

    void elements4() {
        const std::size_t blocks = copyCounts()[0];
        for (std::size_t b = 0; b < blocks; ++b) {
            const auto [dimension, entity, type, n] = copyBlock();
            for (std::size_t k = 0; k < n; ++k) {
                copy<std::uint64_t>(1 + nodes(type));
                put("\n");
            }
        }
    }

    struct Block {
        std::int32_t first, second, third;
        std::size_t size;
    };
    /// The head of a block of 4.1: three numbers and how many things it has.
    Block copyBlock() {
        const auto first = bytes_.take<std::int32_t>(), second = bytes_.take<std::int32_t>(),
                   third = bytes_.take<std::int32_t>();
        const Block block{first, second, third, bytes_.takeCount()};
        put("{} {} {} {}\n", first, second, third, block.size);
        return block;
    }
    /// The head of a section of 4.1: the first number is how many blocks there are.
    std::array<std::uint64_t, 4> copyCounts() {
        std::array<std::uint64_t, 4> counts;
        for (auto& n : counts) n = bytes_.take<std::uint64_t>();
        put("{} {} {} {}\n", counts[0], counts[1], counts[2], counts[3]);
        return counts;
    }
    std::size_t copyCountLine() {
        const std::string line = bytes_.line();
        put("{}\n", line);
        return bytes_.countIn(line);
    }
    std::size_t nodes(int type) const {
        const auto found = nodesOf.find(type);
        if (found == nodesOf.end())
            bytes_.fail(fmt::format(
                "Gmsh's element type {}: only lines (1), triangles (2) and tetrahedra (4) are possible", type));
        return found->second;
    }

    template <class... Values>
    void put(fmt::format_string<const Values&...> format, const Values&... values) {
        fmt::format_to(std::back_inserter(text_), format, values...);
    }
    /// A number of whole numbers, and these.
    void copyList() {
        const std::size_t n = bytes_.takeCount();
        put("{} ", n);
        copy<std::int32_t>(n);
    }
    template <class T>
    void copy(std::size_t n) {
        for (; n > 0; --n) put("{} ", bytes_.take<T>());
    }

    MshBytes bytes_;
    bool known_ = false;  // the format
    bool new_ = false;    // 4.1
    std::string text_;
};

}  // namespace

bool isBinaryMsh(const std::string& content) {
    const std::string format = formatLine(content);
    const auto space = format.find(' ');
    return space != std::string::npos && format.compare(space, 3, " 1 ") == 0;
}

std::string textOfBinaryMsh(const std::string& content, const std::string& name) {
    return BinaryMsh(content, name).text();
}

}  // namespace pfem
