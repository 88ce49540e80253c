#include "linear/eliminationTree.hpp"

#include <algorithm>
#include <numeric>

namespace pfem {

namespace {

/// Parent of each eliminated column: the first row below the diagonal in its column of the factor, -1 when that is
/// not eliminated (Liu, with compressed paths).
std::vector<int> parents(const LowerRows& A, int n) {
    std::vector<int> parent(n, -1), ancestor(n, -1);
    for (int i = 0; i < n; ++i)
        for (int s = A.start[i]; s < A.start[i + 1]; ++s)
            for (int k = A.column[s]; k < i;) {
                const int next = ancestor[k];
                if (next == i) break;
                ancestor[k] = i;
                if (next < 0) {
                    parent[k] = i;
                    break;
                }
                k = next;
            }
    return parent;
}

/// Entries below the diagonal per column of the factor: row i of L holds the paths from A's entries up to i.
std::vector<int> columnCounts(const LowerRows& A, const std::vector<int>& parent) {
    const int n = static_cast<int>(parent.size());
    std::vector<int> count(n, 0), mark(n, -1);
    for (int i = 0; i < A.n; ++i)
        for (int s = A.start[i]; s < A.start[i + 1]; ++s)
            for (int k = A.column[s]; k >= 0 && k < std::min(i, n) && mark[k] != i; k = parent[k]) {
                mark[k] = i;
                ++count[k];
            }
    return count;
}

/// Columns with all children before their parent.
std::vector<int> postOrder(const std::vector<int>& parent) {
    const int n = static_cast<int>(parent.size());
    std::vector<int> child(n, -1), next(n, -1), order, stack;
    order.reserve(n);
    for (int j = n - 1; j >= 0; --j)
        if (parent[j] >= 0) {
            next[j] = child[parent[j]];
            child[parent[j]] = j;
        }
    for (int root = 0; root < n; ++root) {
        if (parent[root] >= 0) continue;
        stack.push_back(root);
        while (!stack.empty()) {
            const int j = stack.back();
            if (child[j] >= 0) {
                stack.push_back(child[j]);
                child[j] = next[child[j]];
            } else {
                order.push_back(j);
                stack.pop_back();
            }
        }
    }
    return order;
}

/// Columns that are to be one front.
struct Group {
    int first, width;
    int below;    // rows under the block
    int parent;   // label of the column above the last one, or -1
    double zeros; // entries that are not of the factor
};

/// Is the joint front worth its zeros? Small fronts always, large ones when they are nearly full.
bool pays(const Group& child, const Group& top, double zeros) {
    const int width = child.width + top.width;
    const double size = 0.5 * width * width + static_cast<double>(width) * top.below;
    return width <= 4 || zeros < (width <= 16 ? 0.5 : width <= 48 ? 0.1 : 0.03) * size;
}

std::vector<Group> groups(const std::vector<int>& parent, const std::vector<int>& count) {
    std::vector<Group> done;
    const int n = static_cast<int>(parent.size());
    for (int j = 0; j < n; ++j) {
        Group top{j, 1, count[j], parent[j], 0};
        while (!done.empty()) {
            const Group& child = done.back();
            if (child.parent < top.first || child.parent >= top.first + top.width) break;
            const double zeros =
                child.zeros + top.zeros + static_cast<double>(child.width) * (top.width + top.below - child.below);
            if (!pays(child, top, zeros)) break;
            top = {child.first, child.width + top.width, top.below, top.parent, zeros};
            done.pop_back();
        }
        done.push_back(top);
    }
    return done;
}

LabelledEntries labelledEntries(const LowerRows& A, const std::vector<int>& label, int n) {
    LabelledEntries entries;
    entries.start.assign(n + 1, 0);
    for (int i = 0; i < A.n; ++i)
        for (int s = A.start[i]; s < A.start[i + 1]; ++s) {
            const int low = std::min(label[i], label[A.column[s]]);
            if (low < n) ++entries.start[low + 1];
        }
    std::partial_sum(entries.start.begin(), entries.start.end(), entries.start.begin());
    entries.row.resize(entries.start.back());
    entries.value.resize(entries.start.back());
    std::vector<int> next(entries.start.begin(), entries.start.end() - 1);
    for (int i = 0; i < A.n; ++i)
        for (int s = A.start[i]; s < A.start[i + 1]; ++s) {
            const auto [low, high] = std::minmax(label[i], label[A.column[s]]);
            if (low >= n) continue;
            entries.row[next[low]] = high;
            entries.value[next[low]++] = A.value[s];
        }
    return entries;
}

/// What is below the columns of each front: its entries and the rows of its children.
void takeRows(const std::vector<Group>& groups, const LabelledEntries& entries, EliminationTree& tree) {
    const int nFronts = static_cast<int>(groups.size());
    tree.fronts.resize(nFronts);
    std::vector<int> frontOf(entries.start.size() - 1), mark(tree.unknown.size(), -1), child(nFronts, -1), next(nFronts, -1);
    int total = 0;
    for (int f = 0; f < nFronts; ++f) {
        std::fill_n(frontOf.begin() + groups[f].first, groups[f].width, f);
        total += groups[f].below;
    }
    tree.row.reserve(total);
    for (int f = 0; f < nFronts; ++f) {
        Front& front = tree.fronts[f];
        front.first = groups[f].first;
        front.width = groups[f].width;
        front.rows = static_cast<int>(tree.row.size());
        const int end = front.first + front.width;
        const auto take = [&](int r) {
            if (r < end || mark[r] == f) return;
            mark[r] = f;
            tree.row.push_back(r);
        };
        for (int s = entries.start[front.first]; s < entries.start[end]; ++s) take(entries.row[s]);
        for (int c = child[f]; c >= 0; c = next[c]) {
            ++front.nChildren;
            for (int k = 0; k < tree.fronts[c].nRows; ++k) take(tree.row[tree.fronts[c].rows + k]);
        }
        front.nRows = static_cast<int>(tree.row.size()) - front.rows;
        std::sort(tree.row.begin() + front.rows, tree.row.end());
        if (groups[f].parent < 0) continue;
        const int up = frontOf[groups[f].parent];
        next[f] = child[up];
        child[up] = f;
    }
}

}  // namespace

EliminationPlan planElimination(const LowerRows& A, int nLast) {
    const int n = A.n - nLast;
    const auto parent = parents(A, n);
    const auto count = columnCounts(A, parent);
    EliminationPlan plan;
    EliminationTree& tree = plan.tree;
    tree.unknown = postOrder(parent);
    for (int i = n; i < A.n; ++i) tree.unknown.push_back(i);
    std::vector<int> label(A.n), parentLabel(n, -1), countOfLabel(n);
    for (int k = 0; k < A.n; ++k) label[tree.unknown[k]] = k;
    for (int k = 0; k < n; ++k) {
        const int up = parent[tree.unknown[k]];
        parentLabel[k] = up < 0 ? -1 : label[up];
        countOfLabel[k] = count[tree.unknown[k]];
    }
    plan.entries = labelledEntries(A, label, n);
    takeRows(groups(parentLabel, countOfLabel), plan.entries, tree);
    return plan;
}

}  // namespace pfem
