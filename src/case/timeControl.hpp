#pragma once
// The clock of a run: which step comes next, when to write, when to stop.

#include <deque>
#include <filesystem>
#include <map>
#include <string>

#include "case/case.hpp"
#include "case/controlDict.hpp"
#include "case/timeFolders.hpp"
#include "case/timeInfo.hpp"
#include "case/writeControl.hpp"

namespace pfem {

/// What the state says about the next step: rates whose product with it is limited [1/s]; 0 where there is nothing to
/// limit.
struct StepRates {
    double courant = 0;      // largest |v|/h of the mesh: maxCo
    double relative = 0;     // that of neighbours to each other: maxRelativeCo
    double compression = 0;  // largest -div v: maxCompression
    double gravityWave = 0;  // sqrt(g/h): maxWaveCo
    double elasticWave = 0;  // largest c/h of the solids: maxSolidCo
};

/// The clock has no time of its own: it answers for the TimeInfo it is given, so that a run restarted from
/// a time folder takes the same steps as one that never stopped.
class TimeControl {
public:
    /// Read system/controlDict and choose the folder to start from; from now on SIGINT and SIGTERM write the
    /// state and stop. Throws UserError when there is no time folder.
    explicit TimeControl(const Case& theCase);

    const ControlDict& controls() const { return controls_; }
    const Dictionary& dictionary() const { return dict_; }

    /// The folder to start from: its name ("0"), its path.
    const std::string& startName() const { return startName_; }
    std::filesystem::path startFolder() const { return root_ / startName_; }

    /// Is there another step to do after `time`?
    bool running(const TimeInfo& time) const;

    /// Nothing is left until endTime.
    bool ended(const TimeInfo& time) const;

    /// Length of the step that comes after `time` [s]. Fixed steps (adjustTimeStep no) are as long as deltaT, whatever
    /// the step before was; others are limited by `rates`, maxDeltaT and maxGrowth times the last one. Fitted so that
    /// the next write with writeControl adjustable, and endTime, are met exactly.
    double deltaT(const TimeInfo& time, const StepRates& rates = {}) const;

    /// The time after a step of length dt from `time`: rounded to the write time, the end time or a multiple
    /// of deltaT when it means one of them.
    TimeInfo advance(const TimeInfo& time, double dt) const;

    /// Is a folder due at `time`, counting every n-th only, or is this the end? Unlike writeDue() this depends on
    /// `time` and the controls alone, not on signals and stopAt.
    bool folderDue(const TimeInfo& time, int n = 1) const { return write_.every(n).due(time) || ended(time); }

    /// Is the state to be written at `time`? Also looks at signals and at a changed controlDict: ask once a
    /// step.
    bool writeDue(const TimeInfo& time);

    /// The name of `time` ("0.05") and its folder. More digits than timePrecision where the step before would have the
    /// same name: that depends on `time` alone, so that a restarted run gives the same names.
    std::string name(const TimeInfo& time) const;
    std::filesystem::path folder(const TimeInfo& time) const { return root_ / name(time); }

    /// Tell that the folder of `time` is written: removes the oldest folder of this run beyond purgeWrite. Was there
    /// one?
    bool written(const TimeInfo& time);

private:
    void readAgainIfChanged();
    bool fixed() const;
    double longest(const TimeInfo& time, const StepRates& rates) const;
    double target(const TimeInfo& time, double dt) const;

    std::filesystem::path root_, file_;
    std::map<std::string, std::filesystem::file_time_type>
        readAt_;  // controlDict and what it includes: when last changed
    Dictionary dict_;
    ControlDict controls_;
    WriteControl write_;
    std::string startName_;
    std::deque<std::string> names_;  // written by this run, for purgeWrite
    bool stop_ = false;
};

}  // namespace pfem
