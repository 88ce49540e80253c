#include <cmath>

#include "dictionary/function1Types.hpp"
#include "waves/makerSignal.hpp"

namespace pfem::function1Detail {

namespace {

/// Displacement of a wave maker at the still level, from rest [m].
struct Motion {
    std::vector<Sine> sines;
    std::shared_ptr<const SolitaryMotion> solitary;  // instead of them
    double ramp = 0, start = 0;                      // [s]
    double flapDepth = 0;                            // of a flap: its motion is an angle; 0: a piston

    double value(double t) const {
        const double since = t - start;
        if (since <= 0) return 0;
        const double grown = since < ramp ? 0.5 * (1 - std::cos(M_PI * since / ramp)) : 1;
        const double x = solitary ? solitary->value(since) : grown * sumAt(sines, since);
        return flapDepth > 0 ? std::atan(x / flapDepth) : x;
    }
};

template <class T>
class MakerMotion : public Function1<T> {
public:
    MakerMotion(Motion motion, T scale) : motion_(std::move(motion)), scale_(std::move(scale)) {}
    T value(double t) const override { return motion_.value(t) * scale_; }
    double outOfPlane() const override { return zOf(scale_); }

private:
    Motion motion_;
    T scale_;
};

double positive(const Dictionary& dict, const std::string& key) {
    const double value = dict.get<double>(key);
    if (!(value > 0)) dict.fatal(key, "Entry '" + key + "' must be positive");
    return value;
}

Motion readMotion(const Dictionary& dict) {
    const auto theory =
        dict.choice("theory", {"airy", "secondOrder", "solitary", "jonswap", "piersonMoskowitz", "focused"}, "airy");
    Flume flume;
    flume.depth = positive(dict, "depth");
    flume.gravity = dict.get("gravity", flume.gravity);
    if (dict.choice("maker", {"piston", "flap"}, "piston") == "flap") flume.maker = Maker::flap;
    Motion motion;
    motion.start = dict.get("start", 0.0);
    if (flume.maker == Maker::flap) motion.flapDepth = flume.depth;
    const double height = positive(dict, "height");
    if ((theory == "solitary" || theory == "secondOrder") && flume.maker == Maker::flap)
        dict.fatal("theory", "The theory '" + theory + "' is that of a piston");
    if (theory == "solitary") {
        motion.solitary = std::make_shared<SolitaryMotion>(height, flume);
        return motion;
    }
    const double period = positive(dict, "period");
    motion.ramp = dict.get("ramp", period);
    if (theory == "airy" || theory == "secondOrder") {
        motion.sines = regularMotion(height, period, theory == "secondOrder", flume);
        return motion;
    }
    Sea sea{height, period};
    sea.gamma = theory == "piersonMoskowitz" ? 1 : dict.get("gamma", sea.gamma);
    sea.components = dict.get("components", sea.components);
    if (sea.components < 1) dict.fatal("components", "A sea needs a component at least");
    sea.seed = dict.get("seed", sea.seed);
    if (theory == "focused") {
        const Focus focus{height, dict.get<double>("focusTime"), dict.get("focusPlace", 0.0)};
        motion.sines = motionFor(focusedGroup(sea, focus, flume.depth, flume.gravity), flume);
    } else
        motion.sines = motionFor(surfaceOf(sea), flume);
    return motion;
}

}  // namespace

template <class T>
Function1Ptr<T> readMakerMotion(const Dictionary& dict) {
    if constexpr (std::is_same_v<T, double>)
        return std::make_shared<MakerMotion<T>>(readMotion(dict), dict.get("scale", 1.0));
    else
        return std::make_shared<MakerMotion<T>>(readMotion(dict),
                                                dict.get("scale", Eigen::Vector3d(Eigen::Vector3d::UnitX())));
}

template Function1Ptr<double> readMakerMotion<double>(const Dictionary&);
template Function1Ptr<Eigen::Vector3d> readMakerMotion<Eigen::Vector3d>(const Dictionary&);

}  // namespace pfem::function1Detail
