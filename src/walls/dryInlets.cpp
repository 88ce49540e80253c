#include "walls/dryInlets.hpp"

#include <algorithm>
#include <cmath>

#include "conditions/inflow.hpp"
#include "mesh/simplex.hpp"
#include "mesh/wallBins.hpp"

namespace pfem {

namespace {

constexpr double filmHeight = 0.5;  // of h, mean of the first triangles

class DryInlet {
public:
    DryInlet(const PassageStep<2>& step, int patch, State<2>& state)
        : step_(step), patch_(patch), state_(state), nodes_(state.nodes), places_(step.topology.walls, state.nodes.x) {
        for (const auto& face : state.mesh.patches[patch].faces) corners_.push_back(face);
        for (const auto& face : corners_) length_ += (nodes_.x[face[1]] - nodes_.x[face[0]]).norm();
        h_ = nodes_.h[corners_[0][0]];
    }

    double length() const { return length_; }

    void bring(double volume) {
        if (row().empty()) layRow();
        const auto nodes = row();
        double carried = 0;
        for (const int i : nodes) {
            const double part = volume / static_cast<double>(nodes.size());
            nodes_.dropVolume[i] += part;
            state_.ledger.book(VolumeCause::inflow, i, part);
            carried += nodes_.dropVolume[i];
        }
        if (carried >= filmHeight * h_ * length_) layFilm(nodes, carried);
    }

private:
    bool isOnPatch(int i) const {
        return std::any_of(nodes_.wall[i].begin(), nodes_.wall[i].end(),
                           [&](int w) { return w >= 0 && step_.topology.walls[w].patch == patch_; });
    }

    /// Nodes on the patch in their order along its first face.
    std::vector<int> row() const {
        std::vector<int> nodes;
        for (int i = 0; i < nodes_.size(); ++i)
            if (isOnPatch(i)) nodes.push_back(i);
        const Vec<2> along = nodes_.x[corners_[0][1]] - nodes_.x[corners_[0][0]];
        std::sort(nodes.begin(), nodes.end(),
                  [&](int a, int b) { return along.dot(nodes_.x[a]) < along.dot(nodes_.x[b]); });
        return nodes;
    }

    int addNode(const Vec<2>& x, const Vec<2>& v) {
        const int i = nodes_.size();
        nodes_.resize(i + 1);
        nodes_.id[i] = state_.nextId++;
        nodes_.x[i] = nodes_.X[i] = x;
        nodes_.v[i] = v;
        nodes_.h[i] = h_;
        for (auto& [cause, amounts] : state_.ledger.fields()) amounts.push_back(0.0);
        return i;
    }

    void support(int i) { nodes_.wall[i] = places_.supportsAt(nodes_.x[i], 1e-6 * h_); }

    void layRow() {
        for (std::size_t f = 0; f < corners_.size(); ++f) {
            const Vec<2> a = nodes_.x[corners_[f][0]], b = nodes_.x[corners_[f][1]];
            const int n = std::max(1, static_cast<int>(std::lround((b - a).norm() / h_)));
            for (int k = f == 0 ? 0 : 1; k <= n; ++k) {
                support(addNode(a + (b - a) * (double(k) / n), Vec<2>::Zero()));
            }
        }
    }

    /// The second row, each node as far before the first as its share of the speed says, and the cells between.
    void layFilm(const std::vector<int>& nodes, double volume) {
        const Inlet& inlet = *step_.conditions.inlet[patch_];
        const auto spread = inletSpread<2>(inlet, corners_, nodes_.x, step_.t1);
        std::vector<double> speed;
        double swept = 0;
        for (const int i : nodes) speed.push_back(std::max(0.0, spread.speed(nodes_.x[i])));
        for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
            const Vec<2> t = nodes_.x[nodes[k + 1]] - nodes_.x[nodes[k]];
            swept +=
                0.5 * (speed[k] + speed[k + 1]) * std::abs(t[0] * spread.direction[1] - t[1] * spread.direction[0]);
        }
        if (!(swept > 0)) return;
        const double rate = inlet.at(step_.t1) * (inlet.ofVolume ? 1 : length_) / swept;
        std::vector<int> front;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            nodes_.dropVolume[nodes[k]] = 0;
            const double way = volume / swept * speed[k];
            front.push_back(nodes[k]);
            if (way < 1e-3 * h_) continue;
            front.back() = addNode(nodes_.x[nodes[k]] + way * spread.direction, rate * speed[k] * spread.direction);
            support(front.back());
        }
        for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
            addCell({nodes[k], nodes[k + 1], front[k + 1]});
            addCell({nodes[k], front[k + 1], front[k]});
        }
    }

    /// Two of the nodes may be one.
    void addCell(Simplex<2> cell) {
        if (cell[0] == cell[1] || cell[1] == cell[2] || cell[2] == cell[0]) return;
        if (simplexMeasure<2>(nodes_.x, cell) < 0) std::swap(cell[1], cell[2]);
        state_.mesh.fluid.nodes.push_back(cell);
        const auto& material = state_.mesh.fluid.material;
        state_.mesh.fluid.material.push_back(material.empty() ? 0 : material[0]);
    }

    const PassageStep<2>& step_;
    int patch_;
    State<2>& state_;
    Nodes<2>& nodes_;
    WallBins<2> places_;
    std::vector<Face<2>> corners_;  // nodes of the patch's faces
    double length_ = 0, h_ = 0;
};

template <int Dim>
bool isDry(const PassageStep<Dim>& step, int patch, const State<Dim>& state) {
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int i : cell)
            for (const int w : state.nodes.wall[i])
                if (w >= 0 && step.topology.walls[w].patch == patch) return false;
    return true;
}

}  // namespace

template <>
void fillDryInlets<2>(const PassageStep<2>& step, State<2>& state) {
    for (int k = 0; k < static_cast<int>(step.conditions.inlet.size()); ++k) {
        if (!step.conditions.inlet[k] || !isDry<2>(step, k, state)) continue;
        const Inlet& inlet = *step.conditions.inlet[k];
        DryInlet dry(step, k, state);
        const double volume = inlet.during(step.t0, step.t1) * (inlet.ofVolume ? 1 : dry.length());
        if (volume > 0) dry.bring(volume);
    }
}

template <>
void fillDryInlets<3>(const PassageStep<3>&, State<3>&) {}

template <int Dim>
int dryInlet(const PassageStep<Dim>& step, const State<Dim>& state) {
    for (int k = 0; k < static_cast<int>(step.conditions.inlet.size()); ++k) {
        const auto& inlet = step.conditions.inlet[k];
        if (inlet && inlet->during(step.t0, step.t1) > 0 && isDry<Dim>(step, k, state)) return k;
    }
    return -1;
}

#define PFEM_INSTANTIATE(D) template int dryInlet<D>(const PassageStep<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
