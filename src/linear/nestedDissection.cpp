#include "linear/nestedDissection.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <span>

namespace pfem {

namespace {

constexpr int smallPiece = 12;                    // dense elimination is quicker than further parting
constexpr int sampleSize = 255, fewSites = 2000;  // fewer are halved exactly, others by the median of a sample

template <int Dim>
class Dissector {
public:
    Dissector(const MatrixGraph& graph, const Places<Dim>& place)
        : graph_(graph),
          half_(place.size(), 0),
          mate_(place.size(), -1),
          reached_(place.size(), 0),
          firstAcross_(place.size(), 0),
          endAcross_(place.size(), 0) {
        site_.reserve(place.size());
        double farthest = 0;
        for (int i = 0; i < static_cast<int>(place.size()); ++i) {
            double squared = 0;
            for (int s = graph.start[i]; s < graph.start[i + 1]; ++s)
                squared = std::max(squared, (place[graph.neighbour[s]] - place[i]).squaredNorm());
            site_.push_back({place[i], 0, std::sqrt(squared) * (1 + 1e-9), i});
            farthest = std::max(farthest, place[i].norm());
        }
        for (Site& site : site_) site.reach += 1e-14 * farthest;  // round-off of places far from the origin
    }

    Dissection dissect() {
        dissect(0, static_cast<int>(site_.size()));
        for (const Site& site : site_) result_.order.push_back(site.unknown);
        return std::move(result_);
    }

private:
    using Vector = Eigen::Matrix<double, Dim, 1>;
    using Matrix = Eigen::Matrix<double, Dim, Dim>;
    struct Site {
        Vector x;
        double along;  // the normal of the cut
        double reach;  // distance of the farthest neighbour
        int unknown;
        bool operator<(const Site& other) const {
            return along < other.along || (along == other.along && unknown < other.unknown);
        }
    };

    /// The direction in which the sites begin ... end - 1 extend most.
    Vector direction(int begin, int end) const {
        Vector sum = Vector::Zero();
        Matrix squares = Matrix::Zero();
        for (int k = begin; k < end; ++k) {
            const Vector x = site_[k].x - site_[begin].x;
            sum += x;
            squares += x * x.transpose();
        }
        Eigen::SelfAdjointEigenSolver<Matrix> solver;
        solver.computeDirect(squares - sum * sum.transpose() / (end - begin));
        return solver.eigenvectors().col(Dim - 1);
    }

    /// Neighbours of an unknown of the first half in the second; both face the cut.
    std::span<const int> across(int unknown) const {
        return {across_.data() + firstAcross_[unknown], across_.data() + endAcross_[unknown]};
    }

    /// Lists what lies across the cut from an unknown of the first half; false where nothing does.
    bool listAcross(int unknown) {
        firstAcross_[unknown] = static_cast<int>(across_.size());
        for (int s = graph_.start[unknown]; s < graph_.start[unknown + 1]; ++s)
            if (half_[graph_.neighbour[s]] == (half_[unknown] ^ 1)) across_.push_back(graph_.neighbour[s]);
        endAcross_[unknown] = static_cast<int>(across_.size());
        return firstAcross_[unknown] < endAcross_[unknown];
    }

    /// Whether an unknown of the second half meets the first one.
    bool meetsFirst(int unknown) const {
        for (int s = graph_.start[unknown]; s < graph_.start[unknown + 1]; ++s)
            if (half_[graph_.neighbour[s]] == (half_[unknown] ^ 1)) return true;
        return false;
    }

    /// A path of alternating pairs from a single unknown of the first half to one of the second: they find mates. Who
    /// is single is looked for first, for that ends the search. The border does not depend on which pairs are made.
    bool findMate(int unknown) {
        for (const int other : across(unknown))
            if (mate_[other] < 0) {
                pair(unknown, other);
                return true;
            }
        for (const int other : across(unknown)) {
            if (reached_[other] == search_) continue;
            reached_[other] = search_;
            if (!findMate(mate_[other])) continue;
            pair(unknown, other);
            return true;
        }
        return false;
    }

    void pair(int unknown, int other) {
        mate_[other] = unknown;
        mate_[unknown] = other;
    }

    /// Mark what alternating paths from an unknown of the first half reach.
    void reach(int unknown) {
        reached_[unknown] = search_;
        for (const int other : across(unknown)) {
            if (reached_[other] == search_) continue;
            reached_[other] = search_;
            if (reached_[mate_[other]] != search_) reach(mate_[other]);
        }
    }

    /// Two halves of about equal number, parted along the cut's normal: where the second begins and how far along it
    /// lies.
    std::pair<int, double> halve(int begin, int end) {
        if (end - begin < fewSites) {
            const int middle = begin + (end - begin) / 2;
            std::nth_element(site_.begin() + begin, site_.begin() + middle, site_.begin() + end);
            return {middle, site_[middle].along};
        }
        sample_.clear();
        for (int k = 0; k < sampleSize; ++k)
            sample_.push_back(site_[begin + static_cast<std::ptrdiff_t>(end - begin) * k / sampleSize]);
        std::nth_element(sample_.begin(), sample_.begin() + sampleSize / 2, sample_.end());
        const Site median = sample_[sampleSize / 2];
        const auto second =
            std::partition(site_.begin() + begin, site_.begin() + end, [&](const Site& s) { return s < median; });
        return {static_cast<int>(second - site_.begin()), median.along};
    }

    /// The fewest sites without which the halves do not meet (Koenig: as many as pairs can be made), ascending.
    void chooseBorder(int begin, int middle, int end, double cut) {
        facing_.clear();
        across_.clear();
        for (int k = begin; k < end; ++k) {
            if (std::abs(site_[k].along - cut) > site_[k].reach) continue;
            const int unknown = site_[k].unknown;
            if (!(k < middle ? listAcross(unknown) : meetsFirst(unknown))) continue;
            mate_[unknown] = -1;
            facing_.push_back(k);
        }
        for (const int k : facing_) {
            if (k >= middle) break;
            ++search_;
            findMate(site_[k].unknown);
        }
        ++search_;
        for (const int k : facing_)
            if (k < middle && mate_[site_[k].unknown] < 0) reach(site_[k].unknown);
        std::erase_if(facing_, [&](int k) { return (reached_[site_[k].unknown] == search_) != (k >= middle); });
    }

    /// Moves the sites of the border to the end; returns where the second half and the border begin.
    std::pair<int, int> part(int begin, int end) {
        const Vector d = direction(begin, end);
        for (int k = begin; k < end; ++k) site_[k].along = d.dot(site_[k].x);
        const auto [middle, cut] = halve(begin, end);
        nHalves_ += 2;
        for (int k = begin; k < end; ++k) half_[site_[k].unknown] = nHalves_ + (k >= middle);
        chooseBorder(begin, middle, end, cut);
        if (facing_.empty()) return {middle, end};
        moved_.clear();
        for (const int k : facing_) {
            moved_.push_back(site_[k]);
            half_[site_[k].unknown] = 0;
        }
        int to = facing_[0];
        for (std::size_t b = 0; b < facing_.size(); ++b)
            for (int k = facing_[b] + 1; k < (b + 1 < facing_.size() ? facing_[b + 1] : end); ++k)
                site_[to++] = site_[k];
        std::copy(moved_.begin(), moved_.end(), site_.begin() + to);
        const auto ofFirst = std::lower_bound(facing_.begin(), facing_.end(), middle) - facing_.begin();
        return {middle - static_cast<int>(ofFirst), to};
    }

    /// Returns the number of pieces that no other of these parts.
    int dissect(int begin, int end) {
        if (end - begin <= smallPiece) {
            if (begin == end) return 0;
            result_.pieces.push_back({begin, end - begin, 0});
            return 1;
        }
        const auto [second, border] = part(begin, end);
        const int children = dissect(begin, second) + dissect(second, border);
        if (border == end) return children;
        result_.pieces.push_back({border, end - border, children});
        return 1;
    }

    const MatrixGraph& graph_;
    std::vector<Site> site_, moved_, sample_;
    // per unknown
    std::vector<int> half_;                     // a number of its own for each half, even for first ones; 0 in a border
    std::vector<int> mate_;                     // the unknown of the other half it is paired with, or -1
    std::vector<int> reached_;                  // the search that came here last
    std::vector<int> firstAcross_, endAcross_;  // in across_, of those that face the cut
    int nHalves_ = 0, search_ = 0;
    std::vector<int> facing_;  // sites that meet the other half, then those of the border
    std::vector<int> across_;
    Dissection result_;
};

}  // namespace

template <int Dim>
Dissection nestedDissection(const MatrixGraph& graph, const Places<Dim>& place) {
    return Dissector<Dim>(graph, place).dissect();
}

template Dissection nestedDissection<2>(const MatrixGraph&, const Places<2>&);
template Dissection nestedDissection<3>(const MatrixGraph&, const Places<3>&);

}  // namespace pfem
