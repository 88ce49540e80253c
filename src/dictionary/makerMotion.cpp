#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "dictionary/function1Types.hpp"
#include "dictionary/makerSurface.hpp"
#include "waves/makerSignal.hpp"
#include "waves/permanentWave.hpp"

namespace pfem::function1Detail {

namespace {

using Signal = std::function<double(double)>;

/// What a wave maker does over time, and the surface that it has then at its place [m].
struct Signals {
    Signal motion;             // displacement at the still level [m]; of an inlet what comes in [m2/s]
    Signal surface = nullptr;  // of pistons
};

struct Motion {
    Signals signals;             // from its start on
    double ramp = 0, start = 0;  // [s]
    double flapDepth = 0;        // of a flap: its motion is an angle; 0: a piston

    double value(double t) const {
        const double x = grown(signals.motion, t);
        return flapDepth > 0 ? std::atan(x / flapDepth) : x;
    }
    /// The signal from rest: it grows over the ramp.
    double grown(const Signal& signal, double t) const {
        const double since = t - start;
        if (since <= 0) return 0;
        const double part = since < ramp ? 0.5 * (1 - std::cos(M_PI * since / ramp)) : 1;
        return part * signal(since);
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
    const auto value = dict.get<double>(key);
    if (!(value > 0)) dict.fatal(key, "Entry '" + key + "' must be positive");
    return value;
}

Signal sumOf(std::vector<Sine> sines) {
    return [sines = std::move(sines)](double t) { return sumAt(sines, t); };
}

/// What makes the waves: a wall of a flume that moves, or an inlet there.
struct Source {
    Flume flume;
    bool inlet = false;
};

/// Those for a surface that is a sum of small waves.
Signals signalsFor(const std::vector<Sine>& surface, const Source& source) {
    if (source.inlet) return {sumOf(inflowFor(surface, source.flume))};
    const auto motion = motionFor(surface, source.flume);
    if (source.flume.maker == Maker::flap) return {sumOf(motion)};
    return {sumOf(motion), sumOf(surfaceAtPiston(motion, source.flume))};
}

/// Waves that go on as they are; what comes in at an inlet is c eta.
Signals permanentSignals(const PermanentWave& wave, const Source& source) {
    if (source.inlet) return {[wave](double t) { return wave.c * wave.surface(wave.k * wave.c * t); }};
    const PermanentMotion motion(wave, source.flume.depth);
    return {[motion](double t) { return motion.value(t); }, [motion](double t) { return motion.surface(t); }};
}

Signals regularSignals(const Dictionary& dict, const std::string& theory, double height, const Source& source) {
    const RegularWave wave{height, positive(dict, "period"), source.flume.depth, source.flume.gravity};
    if (theory == "stokes5" || theory == "cnoidal") {
        const auto permanent = theory == "cnoidal" ? cnoidalWave(wave) : stokesWave(wave);
        const double number = ursell(permanent, wave);
        if (theory == "stokes5" ? number > 40 : number < 10)
            dict.fatal("theory", fmt::format("H L^2/d^3 is {:.3g} (wave length {:.4g} m): above 40 'stokes5' does not "
                                             "hold, below 10 'cnoidal'",
                                             number, 2 * M_PI / permanent.k));
        return permanentSignals(permanent, source);
    }
    const bool secondOrder = theory == "secondOrder";
    if (source.inlet) return signalsFor({{0.5 * height, 2 * M_PI / wave.period, 0}}, source);
    const Signal motion = sumOf(regularMotion(height, wave.period, secondOrder, source.flume));
    if (source.flume.maker == Maker::flap) return {motion};
    return {motion, sumOf(regularSurface(height, wave.period, secondOrder, source.flume))};
}

Signals seaSignals(const Dictionary& dict, const std::string& theory, double height, const Source& source) {
    Sea sea{height, positive(dict, "period")};
    sea.gamma = theory == "piersonMoskowitz" ? 1 : dict.get("gamma", sea.gamma);
    sea.components = dict.get("components", sea.components);
    if (sea.components < 1) dict.fatal("components", "A sea needs a component at least");
    sea.seed = dict.get("seed", sea.seed);
    if (theory != "focused") return signalsFor(surfaceOf(sea), source);
    const Focus focus{height, dict.get<double>("focusTime"), dict.get("focusPlace", 0.0)};
    return signalsFor(focusedGroup(sea, focus, source.flume.depth, source.flume.gravity), source);
}

Motion readMotion(const Dictionary& dict) {
    const auto theory = dict.choice(
        "theory", {"airy", "secondOrder", "stokes5", "cnoidal", "solitary", "jonswap", "piersonMoskowitz", "focused"},
        "airy");
    Source source;
    Flume& flume = source.flume;
    flume.depth = positive(dict, "depth");
    flume.gravity = dict.get("gravity", flume.gravity);
    const auto maker = dict.choice("maker", {"piston", "flap", "inlet"}, "piston");
    if (maker == "flap") flume.maker = Maker::flap;
    source.inlet = maker == "inlet";
    Motion motion;
    motion.start = dict.get("start", 0.0);
    if (maker == "flap") motion.flapDepth = flume.depth;
    const double height = positive(dict, "height");
    const bool permanent = theory == "stokes5" || theory == "cnoidal";
    if ((theory == "solitary" || theory == "secondOrder") && maker != "piston")
        dict.fatal("theory", "The theory '" + theory + "' is that of a piston");
    if (permanent && maker == "flap")
        dict.fatal("theory", "The theory '" + theory + "' is that of a piston or an inlet");
    if (theory == "solitary") {
        const SolitaryMotion wave(height, flume);
        motion.signals = {[wave](double t) { return wave.value(t); }, [wave](double t) { return wave.surface(t); }};
        return motion;
    }
    motion.signals = permanent || theory == "airy" || theory == "secondOrder"
                         ? regularSignals(dict, theory, height, source)
                         : seaSignals(dict, theory, height, source);
    motion.ramp = dict.get("ramp", positive(dict, "period"));
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

namespace pfem {

std::function<double(double)> readMakerSurface(const Dictionary& dict) {
    const auto motion = function1Detail::readMotion(dict);
    if (!motion.signals.surface) dict.fatal("maker", "Only a piston gives way to waves: maker piston");
    return [motion](double t) { return motion.grown(motion.signals.surface, t); };
}

}  // namespace pfem
