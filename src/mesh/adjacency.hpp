#pragma once
// Which cells meet at a node: compressed lists, built once per triangulation.

#include <vector>

#include "mesh/mesh.hpp"

namespace pfem {

/// Cells around node i: entries start[i] ... start[i+1]-1; `corner` is the node's local index in the cell.
struct NodeToCells {
    std::vector<int> start;
    std::vector<int> cell;
    std::vector<int> corner;

    int count(int node) const { return start[node + 1] - start[node]; }
};

template <int Dim>
NodeToCells nodeToCells(const std::vector<Simplex<Dim>>& cells, int nNodes);

/// Which of n nodes are in a cell.
template <int Dim>
std::vector<unsigned char> nodesIn(const std::vector<Simplex<Dim>>& cells, int n) {
    std::vector<unsigned char> marks(n, 0);
    for (const auto& cell : cells)
        for (int node : cell) marks[node] = 1;
    return marks;
}

/// Neighbours of the nodes over cell edges, sorted, without the node itself (compressed lists).
struct NodeToNodes {
    std::vector<int> start;
    std::vector<int> node;
};

/// A face of a cell that no other cell of the same set shares.
template <int Dim>
struct BoundaryFace {
    Face<Dim> nodes;  // cell on the left (2D)
    int cell;
    int opposite;  // local index of the cell's node that is not on the face
};

/// Faces without a neighbour, in the order of cells.
template <int Dim>
std::vector<BoundaryFace<Dim>> boundaryFaces(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around);

/// The nodes around each node, and the faces without a neighbour in the order of cells.
template <int Dim>
struct Surroundings {
    NodeToNodes ring;
    std::vector<BoundaryFace<Dim>> boundary;
};
template <int Dim>
Surroundings<Dim> surroundings(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around);

}  // namespace pfem
