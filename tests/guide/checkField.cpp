// The nodal field `age` of doc/developerGuide.md is written, read and carried to new nodes. Argument: a folder.

#include <cstdio>

#include "io/stateFiles.hpp"

int main(int, char** arguments) {
    using namespace pfem;
    State<2> state;
    state.nodes.resize(3);
    for (int i = 0; i < 3; ++i) {
        state.nodes.id[i] = i;
        state.nodes.age[i] = 0.1 * i;
    }
    state.nodes.x = {{0, 0}, {1, 0}, {0, 1}};
    state.nodes.h.assign(3, 1.0);
    state.nextId = 4;
    state.mesh.fluid = {{{0, 1, 2}}, {0}};
    state.mesh.materials = {"water"};
    writeState<2>(arguments[1], state);
    Nodes<2> nodes = readState<2>(arguments[1]).nodes;
    nodes.appendBetween(nodes, 1, 2);
    const bool right = nodes.age[1] == 0.1 && nodes.age[2] == 0.2 && nodes.age[3] == 0.5 * (0.1 + 0.2);
    if (!right) std::printf("age: %g %g %g\n", nodes.age[1], nodes.age[2], nodes.age[3]);
    return right ? 0 : 1;
}
