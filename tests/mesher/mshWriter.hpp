#pragma once
// A state as Gmsh would write it: every format, with what else such files have.

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "state/state.hpp"

namespace pfem::testing {

struct MshForm {
    bool four = false;  // 4.1, otherwise 2.2
    bool binary = false;
    bool parametric = false;  // nodes with places on their curves and surfaces
    int parts = 1;            // of `gmsh -part`
    bool namesLast = false;   // $PhysicalNames behind the elements
    bool comments = false;    // before $MeshFormat, too
    bool results = false;     // $NodeData twice, $ElementData, $Periodic, $InterpolationScheme
    bool mark = false;        // byte order mark
    bool windows = false;     // ends of lines (text only)
    bool saveAll = false;     // no element is in a physical group
    double height = 0;        // z of one node
};

/// Numbers as text or bytes.
class MshSink {
public:
    explicit MshSink(bool binary) : binary_(binary) {}
    MshSink& i(long value) { return put(static_cast<std::int32_t>(value)); }
    MshSink& u(std::size_t value) { return put(static_cast<std::uint64_t>(value)); }
    MshSink& d(double value) { return put(value); }
    MshSink& list(const std::vector<long>& values) {
        u(values.size());
        for (const long value : values) i(value);
        return *this;
    }
    /// Of a line in text; nothing in bytes.
    void end() {
        if (!binary_) text += "\n";
    }
    void line(const std::string& words) { text += words + "\n"; }

    std::string text;

private:
    template <class T>
    MshSink& put(T value) {
        if (binary_)
            text.append(reinterpret_cast<const char*>(&value), sizeof value);
        else
            text += fmt::format("{} ", value);
        return *this;
    }
    bool binary_;
};

/// Groups: "water" (2, 1) of the fluid, "wall" (2, 2) of the solid, (1, 11 + k) of patch k. Each is one entity:
/// surfaces 1 and 2, curves 21 + k.
class MshWriter {
public:
    MshWriter(const State<2>& state, const MshForm& form) : state_(state), form_(form), out_(form.binary) {}

    std::string text() {
        if (form_.comments) comment("$Nodes are further down");
        out_.line("$MeshFormat");
        out_.line(fmt::format("{} {} 8", form_.four ? "4.1" : "2.2", form_.binary ? 1 : 0));
        if (form_.binary) out_.i(1), out_.line("");
        out_.line("$EndMeshFormat");
        if (!form_.namesLast) names();
        if (form_.four) entities();
        if (form_.four && form_.parts > 1) partitionedEntities();
        if (form_.comments) comment("written by hand");
        form_.four ? nodes4() : nodes2();
        form_.four ? elements4() : elements2();
        if (form_.results) results();
        if (form_.namesLast) names();
        std::string text = form_.mark ? "\xEF\xBB\xBF" + out_.text : out_.text;
        if (form_.windows && !form_.binary)
            for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
                text.replace(at, 1, "\r\n");
        return text;
    }

private:
    struct Block {
        int dimension, entity, group, part;
        std::vector<std::vector<int>> elements;  // nodes
    };

    void comment(const std::string& words) { out_.line("$Comments"), out_.line(words), out_.line("$EndComments"); }

    void names() {
        out_.line("$PhysicalNames");
        out_.line(std::to_string(2 + state_.mesh.patches.size()));
        for (std::size_t k = 0; k < state_.mesh.patches.size(); ++k)
            out_.line(fmt::format("1 {} \"{}\"", 11 + k, state_.mesh.patches[k].name));
        out_.line("2 1 \"water\"");
        out_.line("2 2 \"wall\"");
        out_.line("$EndPhysicalNames");
    }

    int partOf(double x) const {
        double low = x, high = x;
        for (const auto& p : state_.nodes.x) low = std::min(low, p.x()), high = std::max(high, p.x());
        return 1 + std::min(form_.parts - 1, static_cast<int>((x - low) / (high - low) * form_.parts));
    }

    /// Elements by entity and part; with parts also an edge between two of them, which belongs to a surface.
    std::vector<Block> blocks() const {
        std::vector<Block> blocks;
        const auto add = [&](int dimension, int entity, int group, const std::vector<std::vector<int>>& all) {
            for (int part = 1; part <= form_.parts; ++part) {
                Block block{dimension, entity, group, part, {}};
                for (const auto& nodes : all)
                    if (partOf(state_.nodes.x[nodes[0]].x()) == part) block.elements.push_back(nodes);
                blocks.push_back(block);
            }
        };
        for (std::size_t k = 0; k < state_.mesh.patches.size(); ++k) {
            std::vector<std::vector<int>> all;
            for (const auto& f : state_.mesh.patches[k].faces) all.push_back({f[1], f[0]});
            add(1, 21 + static_cast<int>(k), 11 + static_cast<int>(k), all);
        }
        int body = 0;
        for (const auto* cells : {&state_.mesh.fluid, &state_.mesh.solid}) {
            std::vector<std::vector<int>> all;
            for (const auto& t : cells->nodes) all.push_back({t[0], t[1 + all.size() % 2], t[2 - all.size() % 2]});
            ++body;
            add(2, body, body, all);
        }
        return blocks;
    }
    /// Of a part of an entity; that of a cut is 9000.
    long tagOf(const Block& block) const { return form_.parts > 1 ? 100 * block.entity + block.part : block.entity; }

    void entities() {
        out_.line("$Entities");
        out_.u(1).u(state_.mesh.patches.size()).u(2).u(0).end();
        out_.i(5).d(0).d(0).d(0).list({}).end();
        for (std::size_t k = 0; k < state_.mesh.patches.size(); ++k)
            entity(21 + static_cast<long>(k), 11 + static_cast<long>(k));
        for (const long body : {1, 2}) entity(body, body);
        if (form_.binary) out_.line("");
        out_.line("$EndEntities");
    }
    void box() { out_.d(0).d(0).d(0).d(1).d(1).d(0); }
    void entity(long tag, long group) {
        out_.i(tag);
        box();
        out_.list(form_.saveAll ? std::vector<long>{} : std::vector<long>{group}).list({5, -5}).end();
    }

    void partitionedEntities() {
        const auto all = blocks();
        std::size_t curves = 1, surfaces = 0;
        for (const auto& block : all) (block.dimension == 1 ? curves : surfaces) += 1;
        out_.line("$PartitionedEntities");
        out_.u(static_cast<std::size_t>(form_.parts)).end();
        out_.u(1).end();
        out_.i(77).i(1).end();  // a ghost
        out_.u(1).u(curves).u(surfaces).u(0).end();
        out_.i(6).i(0).i(5).list({1}).d(0).d(0).d(0).list({}).end();
        out_.i(9000).i(2).i(1).list({1, 2});  // a cut has the groups of the surface that it cuts
        box();
        out_.list({1}).list({6, -6}).end();
        for (const auto& block : all) {
            out_.i(tagOf(block)).i(block.dimension).i(block.entity).list({block.part});
            box();
            // Gmsh repeats the group of the whole; without, that of the whole counts
            out_.list(block.part % 2 == 1 && !form_.saveAll ? std::vector<long>{block.group} : std::vector<long>{})
                .list({6, -6})
                .end();
        }
        if (form_.binary) out_.line("");
        out_.line("$EndPartitionedEntities");
    }

    double z(std::size_t i) const { return i == 3 ? form_.height : 0; }

    void nodes2() {
        const std::string section = form_.parametric ? "ParametricNodes" : "Nodes";
        out_.line("$" + section);
        out_.line(std::to_string(state_.nodes.size()));
        for (std::size_t i = 0; i < state_.nodes.x.size(); ++i) {
            out_.i(tag(i)).d(state_.nodes.x[i].x()).d(state_.nodes.x[i].y()).d(z(i));
            if (form_.parametric) {
                const long dimension = static_cast<long>(i % 3);
                out_.i(dimension).i(1);
                for (long k = 0; k < dimension; ++k) out_.d(0.5);
            }
            out_.end();
        }
        if (form_.binary) out_.line("");
        out_.line("$End" + section);
    }
    static long tag(std::size_t i) { return 10 + 3 * static_cast<long>(i); }  // with gaps

    /// In two blocks: on a curve and on a surface.
    void nodes4() {
        const std::size_t n = state_.nodes.x.size(), half = n / 2;
        out_.line("$Nodes");
        out_.u(2).u(n).u(10).u(static_cast<std::size_t>(tag(n - 1))).end();
        for (const int dimension : {1, 2}) {
            const std::size_t first = dimension == 1 ? 0 : half, last = dimension == 1 ? half : n;
            out_.i(dimension).i(dimension == 1 ? 21 : 1).i(form_.parametric).u(last - first).end();
            for (std::size_t i = first; i < last; ++i) out_.u(static_cast<std::size_t>(tag(i))).end();
            for (std::size_t i = first; i < last; ++i) {
                out_.d(state_.nodes.x[i].x()).d(state_.nodes.x[i].y()).d(z(i));
                for (int k = 0; k < (form_.parametric ? dimension : 0); ++k) out_.d(0.25);
                out_.end();
            }
        }
        if (form_.binary) out_.line("");
        out_.line("$EndNodes");
    }

    void elements2() {
        std::size_t n = 0;
        const auto all = blocks();
        for (const auto& block : all) n += block.elements.size();
        out_.line("$Elements");
        out_.line(std::to_string(n + 1));
        long number = 1;
        const auto element = [&](long type, const std::vector<long>& tags, const std::vector<int>& nodes) {
            if (form_.binary)
                out_.i(type).i(1).i(static_cast<long>(tags.size())).i(number++);
            else
                out_.i(number++).i(type).i(static_cast<long>(tags.size()));
            for (const long t : tags) out_.i(t);
            for (const int i : nodes) out_.i(tag(static_cast<std::size_t>(i)));
            out_.end();
        };
        element(15, {0, 5}, {0});
        for (const auto& block : all)
            for (const auto& nodes : block.elements) {
                std::vector<long> tags = {form_.saveAll ? 0 : block.group, block.entity};
                if (form_.parts > 1) tags.insert(tags.end(), {2, block.part, -(block.part % form_.parts + 1)});
                element(block.dimension, tags, nodes);
            }
        if (form_.binary) out_.line("");
        out_.line("$EndElements");
    }

    void elements4() {
        auto all = blocks();
        std::erase_if(all, [](const Block& block) { return block.elements.empty(); });
        const auto& t = state_.mesh.fluid.nodes.front();
        std::size_t n = 1, number = 1;
        for (const auto& block : all) n += block.elements.size();
        const bool cut = form_.parts > 1;
        out_.line("$Elements");
        out_.u(all.size() + 1).u(n).u(1).u(n).end();
        out_.i(cut ? 1 : 0).i(cut ? 9000 : 5).i(cut ? 1 : 15).u(1).end();
        out_.u(number++).u(static_cast<std::size_t>(tag(t[0])));
        if (cut) out_.u(static_cast<std::size_t>(tag(t[1])));
        out_.end();
        for (const auto& block : all) {
            out_.i(block.dimension).i(tagOf(block)).i(block.dimension).u(block.elements.size()).end();
            for (const auto& nodes : block.elements) {
                out_.u(number++);
                for (const int i : nodes) out_.u(static_cast<std::size_t>(tag(static_cast<std::size_t>(i))));
                out_.end();
            }
        }
        if (form_.binary) out_.line("");
        out_.line("$EndElements");
    }

    /// Sections that a mesh does not need.
    void results() {
        for (const char* name : {"NodeData", "NodeData", "ElementData", "InterpolationScheme"}) {
            out_.line(std::string("$") + name);
            for (const char* words : {"1", "\"a view\"", "1", "0.0", "3", "0", "1", "1"}) out_.line(words);
            out_.i(10).d(0.5).end();
            if (form_.binary) out_.line("");
            out_.line(std::string("$End") + name);
        }
        out_.line("$Periodic");
        out_.u(0).end();
        if (form_.binary) out_.line("");
        out_.line("$EndPeriodic");
    }

    const State<2>& state_;
    MshForm form_;
    MshSink out_;
};

inline std::string mshText(const State<2>& state, const MshForm& form) { return MshWriter(state, form).text(); }

}  // namespace pfem::testing
