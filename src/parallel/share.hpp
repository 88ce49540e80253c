#pragma once
// What of the loops over nodes and cells this process works off, where others do the rest.

#include <algorithm>
#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

/// Each rank owns a run of the nodes. It works off their cells, the nodes of these, and the cells of those: so much its
/// own nodes' sums over cells take whose numbers are means of nodes. What the others own it gets from them. All members
/// that ask others are collective.
class Share {
public:
    Share() = default;  // of one: everything

    /// `ends`: where each rank's run of nodes ends. `nodes`, `cells`: what this rank works off, ascending.
    Share(const Ranks& ranks, std::vector<std::size_t> ends, std::vector<int> nodes, std::vector<int> cells)
        : part_(std::make_shared<Part>(Part{ranks, std::move(ends), std::move(nodes), std::move(cells)})) {}

    bool isWhole() const { return !part_; }

    /// The nodes and cells to work off, and where each rank's own nodes end; for a part alone.
    const std::vector<std::size_t>& ends() const { return part_->ends; }
    const std::vector<int>& nodes() const { return part_->nodes; }
    const std::vector<int>& cells() const { return part_->cells; }

    /// work(i) for nodes, of n, and cells; as parallelFor.
    template <class Work>
    void forNodes(int n, const Work& work) const {
        isWhole() ? parallelFor(n, work) : forList(nodes(), work);
    }
    template <class Work>
    void forCells(int n, const Work& work) const {
        isWhole() ? parallelFor(n, work) : forList(cells(), work);
    }

    /// Own nodes' values to the others, and theirs in their place.
    template <class Value>
    void gather(std::vector<Value>& perNode) const {
        if (!isWhole()) part_->ranks.complete(perNode, part_->ends);
    }

    /// The first node, of n, for which holds(i), or n.
    template <class Holds>
    int firstNode(int n, const Holds& holds) const {
        return isWhole() ? parallelFirst(n, holds) : firstOf(nodes(), n, holds);
    }
    template <class Holds>
    int firstCell(int n, const Holds& holds) const {
        return isWhole() ? parallelFirst(n, holds) : firstOf(cells(), n, holds);
    }

    /// parallelSum, with its bits, of values that each rank can tell.
    template <class Value>
    auto sum(int n, const Value& value) const {
        return isWhole() ? parallelSum(n, value) : part_->ranks.sum(n, value);
    }

private:
    struct Part {
        Ranks ranks;
        std::vector<std::size_t> ends;
        std::vector<int> nodes, cells;
    };

    template <class Work>
    static void forList(const std::vector<int>& list, const Work& work) {
        parallelFor(static_cast<int>(list.size()), [&](int k) { work(list[k]); });
    }
    template <class Holds>
    int firstOf(const std::vector<int>& list, int n, const Holds& holds) const {
        const int nList = static_cast<int>(list.size());
        const int k = parallelFirst(nList, [&](int at) { return holds(list[at]); });
        const auto firsts = part_->ranks.gather(std::vector<int>{k < nList ? list[k] : n});
        return *std::min_element(firsts.begin(), firsts.end());
    }

    std::shared_ptr<const Part> part_;
};

}  // namespace pfem
