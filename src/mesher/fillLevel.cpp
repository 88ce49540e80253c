#include "mesher/fillLevel.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mesher/outline.hpp"

namespace pfem {

namespace {

/// A piece of the outline below the level, from where it comes down to where it goes up again.
struct Chain {
    Points<2> points;
    std::vector<Location> places;
};

/// All of them, in the outline's order; `start`: a vertex that is not below the level.
std::vector<Chain> chainsBelow(const Body& body, double level, int start) {
    const int n = static_cast<int>(body.points.size());
    const Location cut = body.at("level");
    const auto crossing = [&](const Vec<2>& a, const Vec<2>& b) {
        const double part = (level - a[1]) / (b[1] - a[1]);
        return Vec<2>(a[0] + part * (b[0] - a[0]), level);
    };
    std::vector<Chain> chains;
    bool below = false;
    for (int k = 0; k < n; ++k) {
        const Vec<2>&a = body.points[(start + k) % n], &b = body.points[(start + k + 1) % n];
        if (!below && b[1] < level) {
            chains.push_back({{crossing(a, b)}, {cut}});
            below = true;
        }
        if (!below) continue;
        if (b[1] < level) {
            chains.back().points.push_back(b);
            chains.back().places.push_back(body.atPoint((start + k + 1) % n, "vertices"));
            continue;
        }
        chains.back().points.push_back(crossing(a, b));
        chains.back().places.push_back(cut);
        below = false;
    }
    return chains;
}

/// For each chain the one whose start follows its end along the level: the water is between the crossings of the level
/// in pairs, from left to right.
std::vector<int> followers(const std::vector<Chain>& chains) {
    struct Crossing {
        double x;
        int chain;
        bool end;
    };
    std::vector<Crossing> crossings;
    for (int c = 0; c < static_cast<int>(chains.size()); ++c) {
        crossings.push_back({chains[c].points.front()[0], c, false});
        crossings.push_back({chains[c].points.back()[0], c, true});
    }
    std::stable_sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    std::vector<int> next(chains.size(), -1);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        const auto &a = crossings[k], &b = crossings[k + 1];
        if (a.end != b.end) next[a.end ? a.chain : b.chain] = a.end ? b.chain : a.chain;
    }
    return next;
}

}  // namespace

std::vector<Body> filledUpTo(double level, const Body& body) {
    const auto lowest = std::min_element(body.points.begin(), body.points.end(),
                                         [](const auto& a, const auto& b) { return a[1] < b[1]; });
    if (body.points.size() < 3) return {body};  // refused later
    if (!((*lowest)[1] < level))
        throw UserError(fmt::format("Nothing is below the level: the lowest vertex of '{}' is at y = {:g}, the level "
                                    "at {:g}",
                                    body.name, (*lowest)[1], level),
                        body.at("level"));
    if (!body.arcs.empty() || !body.patches.empty())
        throw UserError("The outline of a body that is filled up to a level has straight edges and no patches",
                        body.at(body.arcs.empty() ? "patches" : "edges"));
    const auto dry = std::find_if(body.points.begin(), body.points.end(), [&](const auto& p) { return p[1] >= level; });
    if (dry == body.points.end()) return {body};
    Body outline = body;
    if (outlineArea(body) < 0) {
        std::reverse(outline.points.begin(), outline.points.end());
        std::reverse(outline.pointPlaces.begin(), outline.pointPlaces.end());
    }
    const auto first =
        std::find_if(outline.points.begin(), outline.points.end(), [&](const auto& p) { return p[1] >= level; });
    const auto chains = chainsBelow(outline, level, static_cast<int>(first - outline.points.begin()));
    const auto next = followers(chains);
    std::vector<Body> pools;
    std::vector<bool> done(chains.size(), false);
    for (int c = 0; c < static_cast<int>(chains.size()); ++c) {
        if (done[c]) continue;
        Body pool = outline;
        pool.points.clear();
        pool.pointPlaces.clear();
        for (int at = c; at >= 0 && !done[at]; at = next[at]) {
            done[at] = true;
            pool.points.insert(pool.points.end(), chains[at].points.begin(), chains[at].points.end());
            pool.pointPlaces.insert(pool.pointPlaces.end(), chains[at].places.begin(), chains[at].places.end());
        }
        if (!pools.empty()) pool.name += std::to_string(pools.size() + 1);
        pools.push_back(std::move(pool));
    }
    return pools;
}

}  // namespace pfem
