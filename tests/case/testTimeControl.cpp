#include <signal.h>

#include <fstream>

#include "../io/sampleState.hpp"
#include "base/error.hpp"
#include "case/interrupt.hpp"
#include "case/timeControl.hpp"
#include "io/stateFiles.hpp"

namespace pfem {

using namespace test;
namespace fs = std::filesystem;

namespace {

/// A case with a time folder 0 and the given controlDict.
class TimeControlTest : public testing::Test {
protected:
    TimeControlTest() {
        fs::create_directories(folder_.path() / "system");
        writeState(folder_.path() / "0", State<2>{});
        clearInterrupt();
    }
    void write(const std::string& controls) {
        std::ofstream(folder_.path() / "system/controlDict") << "FoamFile { format ascii; }\n" << controls;
        // a new modification time also within the clock's resolution
        fs::last_write_time(folder_.path() / "system/controlDict",
                            fs::file_time_type::clock::now() + std::chrono::seconds(++edits_));
    }
    TimeControl open() const { return TimeControl(Case(folder_.path())); }

    TemporaryFolder folder_;
    int edits_ = 0;
};

/// Run to the end; the names of the written times.
std::vector<std::string> run(TimeControl& control, TimeInfo& time, double courantRate = 0) {
    std::vector<std::string> names;
    for (int steps = 0; control.running(time); ++steps) {
        if (steps > 100000) throw InternalError("endless");
        time = control.advance(time, control.deltaT(time, {.courant = courantRate}));
        if (control.writeDue(time)) {
            names.push_back(control.name(time));
            control.written(time);
        }
    }
    return names;
}

}  // namespace

TEST_F(TimeControlTest, TimeStepWrites) {
    write("endTime 0.01; deltaT 0.001; writeControl timeStep; writeInterval 4;");
    TimeControl control = open();
    TimeInfo time;
    EXPECT_EQ(run(control, time), (std::vector<std::string>{"0.004", "0.008", "0.01"}));
    EXPECT_EQ(time.index, 10);
    EXPECT_EQ(time.value, 0.01);
}

TEST_F(TimeControlTest, FixedStepsDoNotAccumulateRounding) {
    write("endTime 10; deltaT 0.001; writeControl runTime; writeInterval 0.1;");
    TimeControl control = open();
    TimeInfo time;
    const auto names = run(control, time);
    ASSERT_EQ(names.size(), 100u);
    EXPECT_EQ(names[2], "0.3");
    EXPECT_EQ(names.back(), "10");
    EXPECT_EQ(time.index, 10000);
    EXPECT_EQ(time.value, 10000 * 0.001);
    EXPECT_EQ(time.deltaT, 0.001);
}

TEST_F(TimeControlTest, AdjustableWritesFallExactlyOnMultiples) {
    write(
        "endTime 2; deltaT 0.0137; writeControl adjustable; writeInterval 0.1; adjustTimeStep yes; maxDeltaT "
        "0.03;");
    TimeControl control = open();
    TimeInfo time;
    int k = 0;
    while (control.running(time)) {
        const double dt = control.deltaT(time);
        EXPECT_LE(dt, 0.0303001);
        if (time.index > 0) {
            EXPECT_LE(dt, 1.2 * 1.011 * time.deltaT0);
        }
        time = control.advance(time, dt);
        if (control.writeDue(time)) {
            ++k;
            EXPECT_EQ(time.value, std::stod(timeName(k * 0.1)));  // to the bit, as a user writes it
            EXPECT_EQ(control.name(time), timeName(k * 0.1));
        }
    }
    EXPECT_EQ(k, 20);
}

TEST_F(TimeControlTest, EndingAtAWriteTimeOrPassingItIsTheSame) {
    const auto timeAfter = [&](const std::string& endTime) {
        write("endTime " + endTime +
              "; deltaT 0.001; writeControl adjustable; writeInterval 0.005; adjustTimeStep yes;");
        TimeControl control = open();
        TimeInfo time;
        while (time.value < 0.9399) time = control.advance(time, control.deltaT(time));
        return time;
    };
    const TimeInfo ended = timeAfter("0.94"), passed = timeAfter("1");  // 188 * 0.005 is not 0.94 to the bit
    EXPECT_EQ(ended.value, 0.94);
    EXPECT_EQ(ended.value, passed.value);
    EXPECT_EQ(ended.deltaT, passed.deltaT);
}

TEST_F(TimeControlTest, AdjustableWithFixedStepKeepsItWhereItFits) {
    write("endTime 0.25; deltaT 0.001; writeControl adjustableRunTime; writeInterval 0.05;");
    TimeControl control = open();
    TimeInfo time;
    while (control.running(time)) {
        const double dt = control.deltaT(time);
        EXPECT_EQ(dt, 0.001);  // the same bits: factorisations can be kept
        time = control.advance(time, dt);
    }
    EXPECT_EQ(time.index, 250);
    EXPECT_EQ(time.value, 5 * 0.05);
}

TEST_F(TimeControlTest, CourantNumberLimitsTheStep) {
    write("endTime 1; deltaT 0.01; adjustTimeStep yes; maxCo 0.5; writeControl none;");
    TimeControl control = open();
    TimeInfo time;
    EXPECT_NEAR(control.deltaT(time, {.courant = 1000}), 0.0005, 1e-18);  // at once
    time = control.advance(time, 0.0005);
    EXPECT_NEAR(control.deltaT(time, {.courant = 1}), 1.2 * 0.0005, 1e-6);  // growth damped
    EXPECT_EQ(time.deltaT0, 0.0005);
    write("endTime 1; deltaT 0.01; adjustTimeStep yes; maxCo 0.5; maxGrowth 3; writeControl none;");
    EXPECT_NEAR(open().deltaT(time, {.courant = 1}), 3 * 0.0005, 2e-6);
}

TEST_F(TimeControlTest, RelativeVelocityAndCompressionLimitTheStep) {
    write(
        "endTime 1; deltaT 0.01; adjustTimeStep yes; maxCo 10; maxRelativeCo 0.25; maxCompression 0.5; writeControl "
        "none;");
    TimeControl control = open();
    const TimeInfo time;
    EXPECT_NEAR(control.deltaT(time, {1, 1000}), 0.00025, 1e-18);
    EXPECT_NEAR(control.deltaT(time, {1, 1, 1000}), 0.0005, 1e-18);
    EXPECT_NEAR(control.deltaT(time, {1, 1000, 1000}), 0.00025, 1e-18);  // the smaller one
    EXPECT_NEAR(control.deltaT(time, {1, 1, 1}), 0.01, 1e-18);
}

TEST_F(TimeControlTest, ARejectedStepStillMeetsTheWriteTime) {
    write("endTime 0.2; deltaT 0.01; writeControl adjustable; writeInterval 0.1;");
    TimeControl control = open();
    TimeInfo time;
    std::vector<double> written;
    while (control.running(time)) {
        double dt = control.deltaT(time);
        if (time.index == 4 || time.index == 12) dt /= 4;  // the solver halved it twice
        time = control.advance(time, dt);
        if (control.writeDue(time)) written.push_back(time.value);
    }
    EXPECT_EQ(written, (std::vector<double>{0.1, 0.2}));
}

TEST_F(TimeControlTest, RestartTakesTheSameSteps) {
    write(
        "endTime 1; deltaT 0.0137; writeControl adjustable; writeInterval 0.1; adjustTimeStep yes; maxCo "
        "0.3;");
    auto rate = [](const TimeInfo& t) { return 10 * (1.5 + std::sin(20 * t.value)); };
    TimeControl whole = open();
    std::vector<TimeInfo> all{TimeInfo{}};
    while (whole.running(all.back()))
        all.push_back(whole.advance(all.back(), whole.deltaT(all.back(), {.courant = rate(all.back())})));
    for (std::size_t from = 0; from < all.size(); from += 7) {
        TimeControl restarted = open();
        TimeInfo time = all[from];
        for (std::size_t i = from + 1; i < all.size(); ++i) {
            time = restarted.advance(time, restarted.deltaT(time, {.courant = rate(time)}));
            ASSERT_EQ(time.value, all[i].value);
            ASSERT_EQ(time.deltaT, all[i].deltaT);
            ASSERT_EQ(restarted.writeDue(time), whole.writeDue(all[i]));
        }
        EXPECT_FALSE(restarted.running(time));
    }
}

TEST_F(TimeControlTest, OtherControlsAtARestart) {
    struct Change {
        std::string before, after;
        double rate;  // of the second run [1/s]
        int steps;    // of the second run
        double first, last;
        std::string names;  // of its folders
    };
    const std::string fixed = "adjustTimeStep no; writeControl runTime; ",
                      free = "adjustTimeStep yes; writeControl adjustable; ";
    const std::string fixed1ms = fixed + "deltaT 1e-3; writeInterval 5e-3; endTime 0.02;";
    const std::string free1ms = free + "deltaT 1e-3; maxDeltaT 1e-3; writeInterval 5e-3; endTime 0.02;";
    const std::string fitted1ms = "writeControl adjustable; deltaT 1e-3; writeInterval 5e-3; endTime 0.02;";
    const Change changes[] = {
        // deltaT of fixed steps
        {fixed1ms, fixed + "deltaT 1e-5; writeInterval 1e-4; endTime 0.0204;", 0, 40, 1e-5, 1e-5,
         "0.0201 0.0202 0.0203 0.0204"},
        {fixed1ms, fixed + "deltaT 1e-8; writeInterval 1; endTime 0.02000003;", 0, 3, 1e-8, 1e-8, "0.02000003"},
        {fixed1ms, fixed + "deltaT 0.01; writeInterval 0.02; endTime 0.05;", 0, 3, 0.01, 0.01, "0.04 0.05"},
        {fixed1ms, fixed + "deltaT 7e-4; writeInterval 7e-3; endTime 0.027;", 0, 10, 7e-4, 7e-4, "0.0214 0.027"},
        {fixed1ms, fitted1ms + "deltaT 1e-4; endTime 0.021;", 0, 10, 1e-4, 1e-4, "0.021"},
        {fitted1ms, fitted1ms + "deltaT 5e-3; endTime 0.03;", 0, 2, 5e-3, 5e-3, "0.025 0.03"},
        // endTime
        {fixed1ms, fixed1ms + "endTime 0.0204;", 0, 1, 4e-4, 4e-4, "0.0204"},
        {fixed1ms, fixed1ms + "endTime 0.0225;", 0, 3, 1e-3, 5e-4, "0.0225"},
        {fixed1ms, fixed1ms + "endTime 0.02000001;", 0, 1, 1e-8, 1e-8, "0.02000001"},
        {fixed1ms, fixed1ms + "endTime 0.02;", 0, 0, 0, 0, ""},
        {fixed1ms, fixed1ms + "endTime 0.01;", 0, 0, 0, 0, ""},
        {fixed1ms + "endTime 0.0175;", fixed1ms + "endTime 0.03;", 0, 13, 5e-4, 1e-3,
         "0.02 0.025 0.03"},  // on the grid again
        {free1ms, free1ms + "endTime 0.0202;", 0, 1, 2e-4, 2e-4, "0.0202"},
        {free1ms, free1ms + "endTime 0.027;", 0, 7, 1e-3, 1e-3, "0.025 0.027"},
        // writeInterval and writeControl
        {fixed1ms, fixed1ms + "writeInterval 2e-3; endTime 0.026;", 0, 6, 1e-3, 1e-3, "0.022 0.024 0.026"},
        {free1ms, free1ms + "writeInterval 3e-3; endTime 0.03;", 0, 10, 1e-3, 1e-3, "0.021 0.024 0.027 0.03"},
        {free1ms, free1ms + "writeInterval 25e-3; endTime 0.03;", 0, 10, 1e-3, 1e-3, "0.025 0.03"},
        {fixed1ms, fixed1ms + "writeControl timeStep; writeInterval 8; endTime 0.03;", 0, 10, 1e-3, 1e-3, "0.024 0.03"},
        {fixed1ms, fixed1ms + "writeControl adjustable; writeInterval 25e-4; endTime 0.025;", 0, 6, 25e-4 / 3,
         25e-4 / 3, "0.0225 0.025"},
        {fitted1ms + "writeInterval 25e-4;", fixed1ms + "endTime 0.025;", 0, 5, 1e-3, 1e-3, "0.025"},
        {fixed1ms, fixed1ms + "writeControl none; endTime 0.03;", 0, 10, 1e-3, 1e-3, "0.03"},
        // adjustTimeStep, with the limits of either
        {free1ms, fixed1ms + "endTime 0.03;", 1e6, 10, 1e-3, 1e-3, "0.025 0.03"},
        {free1ms + "maxDeltaT 1e-5;", fixed1ms + "endTime 0.03;", 0, 10, 1e-3, 1e-3, "0.025 0.03"},
        {fixed1ms + "deltaT 1e-4;", free1ms + "endTime 0.025;", 0, 15, 12e-5, 0, "0.025"},  // grows by maxGrowth
        {fixed1ms, free1ms + "endTime 0.025; maxDeltaT 1e-4;", 0, 50, 1e-4, 1e-4, "0.025"},
        {free1ms, free1ms + "endTime 0.025; maxDeltaT 1e-4;", 0, 50, 1e-4, 1e-4, "0.025"},
        {free1ms, free1ms + "endTime 0.025; maxCo 0.1;", 500, 25, 2e-4, 2e-4, "0.025"},
        {free1ms + "maxDeltaT 2e-4;", free1ms + "endTime 0.025;", 0, 11, 24e-5, 0, "0.025"},
        {free1ms, free1ms + "endTime 0.025; deltaT 1e-7;", 0, 5, 1e-3, 1e-3,
         "0.025"},  // deltaT is the case's first step only
        // names
        {fixed1ms, fixed1ms + "timePrecision 1; endTime 0.03;", 0, 10, 1e-3, 1e-3, "0.025 0.03"},
        {fixed1ms, fixed1ms + "timePrecision 2; deltaT 1e-5; endTime 0.0201; writeInterval 5e-5;", 0, 10, 1e-5, 1e-5,
         "0.02005 0.0201"},
        {fixed1ms, fixed1ms + "timeFormat scientific; timePrecision 2; endTime 0.03;", 0, 10, 1e-3, 1e-3,
         "2.50e-02 3.00e-02"},
    };
    for (const auto& change : changes) {
        TimeInfo time;
        write(change.before);
        TimeControl before = open();
        run(before, time);
        write(change.after);
        TimeControl after = open();
        const int index = time.index;
        std::vector<double> steps;
        std::string names;
        while (after.running(time) && steps.size() < 1000) {
            time = after.advance(time, after.deltaT(time, {.courant = change.rate}));
            steps.push_back(time.deltaT0);
            if (after.writeDue(time)) names += (names.empty() ? "" : " ") + after.name(time);
        }
        const std::string what = change.before + "\n    -> " + change.after;
        EXPECT_EQ(time.index - index, change.steps) << what;
        EXPECT_EQ(names, change.names) << what;
        if (steps.empty() || change.steps == 0) continue;
        EXPECT_NEAR(steps.front() / change.first, 1, 0.011) << what;
        if (change.last > 0) {
            EXPECT_NEAR(steps.back() / change.last, 1, 0.011) << what;
        }
        EXPECT_EQ(time.value, after.controls().endTime) << what;
    }
}

TEST_F(TimeControlTest, OtherControlsWhileItRuns) {
    const std::string rest = "endTime 0.02; writeControl runTime; writeInterval 5e-3; ";
    write(rest + "deltaT 1e-3;");
    TimeControl control = open();
    TimeInfo time;
    const auto until = [&](double end) {
        std::string names;
        while (control.running(time) && time.value < end - 1e-9) {
            time = control.advance(time, control.deltaT(time, {.courant = 100}));
            if (control.writeDue(time)) names += control.name(time) + " ";
        }
        return names;
    };
    const auto change = [&](const std::string& controls) {
        write(controls);
        control.writeDue(time);  // reads it again
    };
    EXPECT_EQ(until(0.006), "0.005 ");
    change(rest + "deltaT 5e-4;");
    EXPECT_EQ(until(0.012), "0.01 ");
    EXPECT_EQ(time.index, 6 + 12);
    change(rest + "deltaT 2e-3;");
    EXPECT_EQ(until(0.014), "");
    EXPECT_EQ(time.index, 6 + 12 + 1);
    change(rest + "deltaT 1e-3; adjustTimeStep yes; maxCo 0.01;");  // 1e-4 s
    EXPECT_EQ(until(0.015), "0.015 ");
    EXPECT_EQ(time.index, 6 + 12 + 1 + 10);
    change(rest + "deltaT 1e-3;");
    EXPECT_EQ(control.deltaT(time), 1e-3);
    change(rest + "deltaT 1e-3; endTime 0.0165; writeControl adjustable; writeInterval 1e-3;");
    EXPECT_EQ(until(1), "0.016 0.0165 ");
    EXPECT_EQ(time.value, 0.0165);
}

TEST_F(TimeControlTest, ARejectedFixedStepReturnsToTheGrid) {
    write("endTime 0.02; deltaT 1e-3; writeControl runTime; writeInterval 5e-3;");
    const auto names = [&](bool restarts) {
        TimeControl control = open();
        TimeInfo time;
        std::string all;
        for (int steps = 0; control.running(time) && steps < 1000; ++steps) {
            double dt = control.deltaT(time);
            if (steps == 3 || steps == 4) dt /= 8;  // the solver halved it three times
            if (steps == 14) dt /= 2;
            time = control.advance(time, dt);
            if (control.writeDue(time)) all += control.name(time) + " ";
            if (restarts) control = open();
            if (steps > 20) {
                EXPECT_EQ(time.deltaT0, 1e-3);
            }
        }
        EXPECT_EQ(time.value, 0.02);
        return all + std::to_string(time.index);
    };
    EXPECT_EQ(names(false), "0.005 0.01 0.015 0.02 23");
    EXPECT_EQ(names(true), names(false));
}

TEST_F(TimeControlTest, EndingOnAFixedStepOrPassingItIsTheSame) {
    const auto timeAfter = [&](const std::string& endTime) {
        write("endTime " + endTime + "; deltaT 0.1; writeControl runTime; writeInterval 0.1;");
        TimeControl control = open();
        TimeInfo time;
        while (time.value < 0.29) time = control.advance(time, control.deltaT(time));
        return time.value;
    };
    EXPECT_EQ(timeAfter("0.3"), 0.3);
    EXPECT_EQ(timeAfter("1"), 0.3);  // 3 * 0.1 is not 0.3 to the bit
}

TEST_F(TimeControlTest, TinyStepsLateAreNotRoundedAway) {
    write("endTime 1001; deltaT 2e-9; writeControl adjustable; writeInterval 4e-9;");
    TimeControl control = open();
    TimeInfo time{1000, 1, 2e-9, 2e-9};
    for (int k = 1; k <= 10; ++k) {
        time = control.advance(time, control.deltaT(time));
        EXPECT_NEAR(time.value - 1000, k * 2e-9, 3e-13);
        EXPECT_EQ(control.writeDue(time), k % 2 == 0);
    }
}

TEST_F(TimeControlTest, StartFrom) {
    for (const char* name : {"0.1", "0.25"}) writeState(folder_.path() / name, State<2>{});
    fs::create_directories(folder_.path() / "0.5");  // a broken one is passed over
    const std::string rest = " endTime 1; deltaT 0.1;";
    write("startFrom firstTime;" + rest);
    EXPECT_EQ(open().startName(), "0");
    write(rest);
    EXPECT_EQ(open().startName(), "0.25");
    write("startFrom startTime; startTime 0.1;" + rest);
    EXPECT_EQ(open().startFolder(), fs::canonical(folder_.path()) / "0.1");
    write("startFrom startTime; startTime 0.3;" + rest);
    EXPECT_THROW(open(), UserError);
    for (const char* name : {"2e-10", "4e-10"}) writeState(folder_.path() / name, State<2>{});
    write("startFrom startTime; startTime 4e-10; endTime 1e-9; deltaT 1e-11;");  // a case of nanoseconds, or in other
                                                                                 // units
    EXPECT_EQ(open().startName(), "4e-10");
    for (const char* name : {"2e-10", "4e-10"}) fs::remove_all(folder_.path() / name);
    for (const char* name : {"0", "0.1", "0.25"}) fs::remove_all(folder_.path() / name);
    EXPECT_THROW(open(), UserError);
}

TEST_F(TimeControlTest, NamesAreKeptApart) {
    write("endTime 2; deltaT 1e-8; writeControl timeStep; writeInterval 1;");
    TimeControl control = open();
    TimeInfo time;
    time.value = 1;
    time.index = 5;
    time.deltaT = 1e-8;
    const TimeInfo next = control.advance(time, 1e-8);
    EXPECT_NE(control.name(time), control.name(next));
    EXPECT_EQ(control.name(next), "1.00000001");
}

TEST_F(TimeControlTest, PurgeKeepsTheLastAndNeverTheStart) {
    write("endTime 0.6; deltaT 0.1; writeControl timeStep; writeInterval 1; purgeWrite 2;");
    TimeControl control = open();
    writeState(folder_.path() / "0.05", State<2>{});  // of another run
    TimeInfo time;
    while (control.running(time)) {
        time = control.advance(time, control.deltaT(time));
        writeState(control.folder(time), State<2>{});
        control.written(time);
    }
    std::vector<std::string> names;
    for (const auto& folder : listTimes(folder_.path()).complete) names.push_back(folder.name);
    EXPECT_EQ(names, (std::vector<std::string>{"0", "0.05", "0.5", "0.6"}));
}

TEST_F(TimeControlTest, EditingTheFileStopsTheRun) {
    const std::string rest = " endTime 100; deltaT 0.1; writeControl timeStep; writeInterval 5; runTimeModifiable yes;";
    for (const auto& [word, steps, writes] : std::vector<std::tuple<std::string, int, bool>>{
             {"writeNow", 3, true}, {"noWriteNow", 3, false}, {"nextWrite", 5, true}}) {
        write("stopAt endTime;" + rest);
        TimeControl control = open();
        TimeInfo time;
        bool written = false;
        while (control.running(time)) {
            time = control.advance(time, control.deltaT(time));
            if (time.index == 3) write("stopAt " + word + ";" + rest);
            written = control.writeDue(time);
        }
        EXPECT_EQ(time.index, steps) << word;
        EXPECT_EQ(written, writes) << word;
    }
}

TEST_F(TimeControlTest, EditingAnIncludedFileActsToo) {
    const fs::path included = folder_.path() / "system/times";
    const auto include = [&](const std::string& text) {
        std::ofstream(included) << text;
        fs::last_write_time(included, fs::file_time_type::clock::now() + std::chrono::seconds(++edits_));
    };
    include("endTime 1;");
    write("deltaT 0.1; #include \"times\"\n");
    TimeControl control = open();
    TimeInfo time = control.advance(TimeInfo{}, 0.1);
    include("endTime 0.3; deltaT 0.05;");
    control.writeDue(time);
    EXPECT_EQ(control.controls().endTime, 0.3);
    EXPECT_EQ(control.deltaT(time), 0.05);
    include("endTime 0.2; deltaT");  // half saved
    control.writeDue(time);
    include("endTime 0.2; deltaT 0.02;");
    control.writeDue(time);
    EXPECT_EQ(control.controls().endTime, 0.2);
    EXPECT_EQ(control.deltaT(time), 0.02);
}

TEST_F(TimeControlTest, AHalfSavedFileDoesNotKillTheRun) {
    write("endTime 1; deltaT 0.1;");
    TimeControl control = open();
    TimeInfo time = control.advance(TimeInfo{}, 0.1);
    write("endTime 1; deltaT ");
    EXPECT_TRUE(control.writeDue(time));
    EXPECT_EQ(control.controls().deltaT, 0.1);
    write("endTime 0.3; deltaT 0.05;");
    control.writeDue(time);
    EXPECT_EQ(control.controls().endTime, 0.3);
    EXPECT_EQ(control.deltaT(time), 0.05);
}

TEST_F(TimeControlTest, SignalWritesAndStops) {
    write("endTime 1; deltaT 0.1; writeControl none;");
    TimeControl control = open();
    catchInterrupts();
    TimeInfo time = control.advance(TimeInfo{}, 0.1);
    EXPECT_FALSE(control.writeDue(time));
    EXPECT_TRUE(control.running(time));
    raise(SIGTERM);
    EXPECT_TRUE(control.running(time)) << "the state at hand is not written yet";
    time = control.advance(time, 0.1);
    EXPECT_TRUE(control.writeDue(time));
    EXPECT_FALSE(control.running(time));
    clearInterrupt();
    signal(SIGINT, SIG_DFL);
}

TEST_F(TimeControlTest, Mistakes) {
    const std::pair<const char*, const char*> mistakes[] = {
        {"deltaT 0.1;", "endTime"},
        {"endTime 1;", "deltaT"},
        {"endTime 1; deltaT 0;", "deltaT"},
        {"endTime 1; deltaT 0.1; writeControl sometimes;", "adjustableRunTime"},
        {"endTime 1; deltaT 0.1; writeInterval 0.5;", "whole number"},
        {"endTime 1; deltaT 0.1; writeInterval -1;", "writeInterval"},
        {"endTime 1; deltaT 0.1; stopAt never;", "noWriteNow"},
        {"endTime 1; deltaT 0.1; timePrecision 99;", "timePrecision"},
    };
    for (const auto& [text, word] : mistakes) {
        write(text);
        try {
            open();
            ADD_FAILURE() << text;
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
            EXPECT_NE(error.where().file.find("controlDict"), std::string::npos);
        }
    }
}

}  // namespace pfem
