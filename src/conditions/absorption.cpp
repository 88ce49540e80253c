#include "conditions/absorption.hpp"

#include <algorithm>
#include <cmath>

#include "dictionary/function1.hpp"
#include "dictionary/makerSurface.hpp"
#include "waves/dispersion.hpp"

namespace pfem {

namespace {

/// Is the displacement a block with `type waveMaker`?
bool isWaveMaker(const Dictionary& motion) {
    if (!motion.found("displacement") || !motion.isDict("displacement")) return false;
    const Dictionary& signal = motion.subDict("displacement");
    return signal.found("type") && signal.get<std::string>("type") == "waveMaker";
}

/// Of `absorb`, else of the wave maker.
double positive(const Dictionary& absorb, const Dictionary* maker, const std::string& key) {
    const Dictionary& from = !absorb.found(key) && maker && maker->found(key) ? *maker : absorb;
    const auto value = from.get<double>(key);
    if (!(value > 0)) from.fatal(key, "Entry '" + key + "' must be positive");
    return value;
}

}  // namespace

double Absorption::answer(double U, double way, double excess, double dt) const {
    const double along = std::max(lag, dt);
    return ((along - 0.5 * dt) * U - dt * (rate * excess + returning * (way + 0.5 * dt * U))) / (along + 0.5 * dt);
}

Absorption readAbsorption(const Dictionary& motion, bool plane) {
    const Dictionary& absorb = motion.subDict("absorb");
    for (const char* key : {"velocity", "angle", "omega"})
        if (motion.found(key))
            motion.fatal(key,
                         "A wall that gives way to waves is a piston: beside 'absorb' it takes a 'displacement' "
                         "with 'type waveMaker', or none");
    const Dictionary* maker = isWaveMaker(motion) ? &motion.subDict("displacement") : nullptr;
    if (motion.found("displacement") && !maker)
        motion.fatal("displacement",
                     "A wall that gives way to waves must know those that it makes itself: beside "
                     "'absorb' a displacement is one with 'type waveMaker'");
    Absorption wall;
    wall.depth = positive(absorb, maker, "depth");
    const double gravity =
        absorb.found("gravity") || (maker && maker->found("gravity")) ? positive(absorb, maker, "gravity") : 9.81;
    const double omega = 2 * M_PI / positive(absorb, maker, "period"),
                 q = waveNumber(omega, wall.depth, gravity) * wall.depth;
    wall.rate = omega / makerGain(Maker::piston, q);
    wall.returning = 0.05 * omega;  // slow beside the waves; the lag makes up for it at omega
    wall.lag = nearFieldGain(q) / (makerGain(Maker::piston, q) * omega) + wall.returning / (omega * omega);
    if (maker) {
        wall.wanted = readMakerSurface(*maker);
        wall.scale = maker->get("scale", Eigen::Vector3d(Eigen::Vector3d::UnitX()));
    }
    wall.up = absorb.get("up", Eigen::Vector3d(plane ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ()));
    if (plane) demandPlane(absorb, "up", wall.up[2]);
    if (!(wall.up.norm() > 0)) absorb.fatal("up", "The direction has no length");
    wall.up.normalize();
    return wall;
}

}  // namespace pfem
