// The entry `functions` as OpenFOAM's users write it: lists, windows of time, rows with the time folders, foreign
// types.

#include <gtest/gtest.h>

#include <sstream>

#include "base/error.hpp"
#include "case/timeFolders.hpp"
#include "caseFolder.hpp"
#include "functions/functionEntries.hpp"
#include "io/table.hpp"

namespace pfem {

using namespace test;
namespace fs = std::filesystem;

namespace {

/// Writes how many steps it has seen since the beginning of the run.
class StepCounter : public FunctionObject<2> {
public:
    explicit StepCounter(const FunctionContext<2>& context) : context_(context) {}
    void start(const State<2>& state) override {
        if (const auto found = state.memory.find(context_.name); found != state.memory.end())
            seen_ = found->second.at(0);
        table_.emplace(context_.folder / "steps", context_.precision, context_.resumeAt);
        table_->header({"Time", "steps"});
    }
    void advance(const State<2>&) override { ++seen_; }
    std::vector<double> memory() const override { return {seen_}; }
    void execute(const State<2>& state) override {
        table_->row({table_->time(state.time.value), table_->number(seen_)});
    }

private:
    FunctionContext<2> context_;
    double seen_ = 0;
    std::optional<Table> table_;
};

const bool added = addFunctionType<2>("stepCounter", [](const Dictionary&, const FunctionContext<2>& context) {
    return std::unique_ptr<FunctionObject<2>>(new StepCounter(context));
});

class FunctionEntriesTest : public testing::Test {
protected:
    FunctionObjects<2> make(const std::string& functions, const std::string& startName = "0",
                            std::optional<double> resumeAt = {}) const {
        dict_ = Dictionary::parse(functions, "controlDict");
        return {Case(folder_.path()), dict_, startName, 12, {}, resumeAt};
    }
    static State<2> at(int k) {
        State<2> state;
        state.time = {0.1 * k, k, 0.1, k > 0 ? 0.1 : 0};
        return state;
    }
    /// Ten steps of 0.1 s with a folder after every second one, and at the end; begun again at the steps `restarts`.
    void run(const std::string& functions, std::vector<int> restarts = {}) const {
        restarts.push_back(10);
        State<2> state = at(0);
        for (const int until : restarts) {
            const int from = state.time.index;
            const auto resumeAt = from > 0 ? std::optional(state.time.value) : std::nullopt;
            auto objects = make(functions, timeName(state.time.value), resumeAt);
            objects.start(state);
            for (int k = from + 1; k <= until; ++k) {
                state = at(k);
                objects.execute(state, [&](int n) { return k % (2 * n) == 0 || k == 10; });
                state.memory = objects.memory();
            }
        }
    }
    std::string text(const std::string& file) const { return readText(folder_.path() / "postProcessing" / file); }
    /// The first columns of a table.
    std::string times(const std::string& file) const {
        std::istringstream lines(text(file));
        std::string all;
        for (std::string line; std::getline(lines, line);) {
            std::string first;
            std::istringstream words(line);
            words >> first;
            if (first[0] != '#') all += first + " ";
        }
        return all;
    }

    TemporaryFolder folder_;
    mutable Dictionary dict_;
};

}  // namespace

TEST_F(FunctionEntriesTest, AListIsAsGoodAsBraces) {
    const std::string body =
        "a { type stepCounter; writeInterval 5; } b { type stepCounter; enabled no; } c { type stepCounter; }";
    run("functions { " + body + " }");
    const std::string a = text("a/0/steps"), c = text("c/0/steps");
    fs::remove_all(folder_.path() / "postProcessing");
    run("functions ( " + body + " );");
    EXPECT_EQ(times("a/0/steps"), "0 0.5 1 ");
    EXPECT_EQ(text("a/0/steps"), a);
    EXPECT_EQ(text("c/0/steps"), c);
    EXPECT_FALSE(fs::exists(folder_.path() / "postProcessing/b"));
    EXPECT_TRUE(dict_.unused().empty());
    EXPECT_EQ(make("functions ();").size(), 0);
    EXPECT_EQ(make("").size(), 0);
    make("functions ( a { type stepCounter; writeInterva 5; } );");
    ASSERT_EQ(dict_.unused().size(), 1u);
    EXPECT_EQ(dict_.unused()[0].suggestion, "writeInterval");
}

TEST_F(FunctionEntriesTest, MistakesInAList) {
    const std::pair<const char*, const char*> mistakes[] = {
        {"functions ( { type stepCounter; } );", "no name"},
        {"functions ( a { type stepCounter; } a { type stepCounter; } );", "twice"},
        {"functions ( \"../a\" { type stepCounter; } );", "postProcessing"},
        {"functions ( a b );", "dictionary"},
        {"functions 3;", "list"},
    };
    for (const auto& [text, word] : mistakes) {
        try {
            make(text);
            ADD_FAILURE() << text;
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << text << "\n" << error.what();
            EXPECT_EQ(error.where().line, 1) << text;
        }
    }
}

TEST_F(FunctionEntriesTest, RowsWithTheTimeFolders) {
    run("functions { a { type stepCounter; writeControl writeTime; } b { type stepCounter; writeControl outputTime; "
        "writeInterval 2; }"
        "c { type stepCounter; outputControl outputTime; } d { type stepCounter; outputControl timeStep; "
        "outputInterval 4; }"
        "e { type stepCounter; executeControl writeTime; executeInterval 3; writeControl writeTime; } }");
    for (const char* file : {"a/0/steps", "c/0/steps", "e/0/steps"})
        EXPECT_EQ(times(file), "0 0.2 0.4 0.6 0.8 1 ") << file;
    EXPECT_EQ(text("e/0/steps"), text("a/0/steps"));
    EXPECT_EQ(times("b/0/steps"), "0 0.4 0.8 1 ");
    EXPECT_EQ(times("d/0/steps"), "0 0.4 0.8 ");
    EXPECT_TRUE(dict_.unused().empty());
    for (const char* words :
         {"writeControl writeTime; writeInterval 1.5;", "writeControl writeTimes;", "executeControl never;",
          "timeStart 2; timeEnd 1;", "outputControl runTime; outputInterval 0;"})
        EXPECT_THROW(make(std::string("functions { a { type stepCounter; ") + words + " } }"), UserError) << words;
}

TEST_F(FunctionEntriesTest, AWindowOfTimeAlsoOverRestarts) {
    const std::string functions =
        "functions { all { type stepCounter; } late { type stepCounter; timeStart 0.3; }"
        "early { type stepCounter; timeEnd 0.7; } between { type stepCounter; timeStart 0.3; timeEnd 0.7; "
        "writeInterval 2; } }";
    run(functions);
    EXPECT_EQ(times("late/0/steps"), "0.3 0.4 0.5 0.6 0.7 0.8 0.9 1 ");
    EXPECT_EQ(times("early/0/steps"), "0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 ");
    EXPECT_EQ(times("between/0/steps"), "0.4 0.6 ");
    EXPECT_EQ(text("between/0/steps").substr(text("between/0/steps").find("0.6")), "0.6                   7\n")
        << "7 states seen";
    const std::string files[] = {"all/0/steps", "late/0/steps", "early/0/steps", "between/0/steps"};
    std::vector<std::string> whole;
    for (const auto& file : files) whole.push_back(text(file));
    for (const std::vector<int>& restarts : {std::vector<int>{1}, {3}, {5}, {7}, {9}, {1, 2, 4, 8}}) {
        fs::remove_all(folder_.path() / "postProcessing");
        run(functions, restarts);
        for (std::size_t i = 0; i < whole.size(); ++i)
            EXPECT_EQ(text(files[i]), whole[i]) << files[i] << " from " << restarts[0];
    }
    // afterwards, from time folders: the same window
    auto later = make(functions, "5");
    later.prepare(at(0));
    for (int k = 0; k <= 10; ++k) later.executeAll(at(k));
    EXPECT_EQ(times("between/5/steps"), "0.3 0.4 0.5 0.6 0.7 ");
}

TEST_F(FunctionEntriesTest, ForeignTypesAreLeftOutWithAWarning) {
    testing::internal::CaptureStderr();
    const auto functions = make(
        "functions\n{\n  mean\n  {\n    type fieldAverage;\n    fields ( U { mean on; } );\n  }\n  a { type "
        "stepCounter; }\n}\n");
    const std::string warning = testing::internal::GetCapturedStderr();
    EXPECT_EQ(functions.names(), std::vector<std::string>{"a"});
    for (const char* words : {"Warning: function 'mean' in controlDict:5 is left out", "fieldAverage",
                              "Valid function types", "massLedger"})
        EXPECT_NE(warning.find(words), std::string::npos) << warning;
    EXPECT_TRUE(dict_.unused().empty());
    // OpenFOAM's own words are foreign, near ones are misspelt
    for (const char* word :
         {"CourantNo",     "coded",       "forceCoeffs",       "fieldAverage",     "fieldValueDelta",
          "flowRatePatch", "patchProbes", "pressure",          "residuals",        "sets",
          "solverInfo",    "streamLine",  "surfaceFieldValue", "turbulenceFields", "timeActivatedFileUpdate",
          "volFieldValue", "vorticity",   "vtkWrite",          "wallShearStress",  "writeObjects"})
        EXPECT_TRUE(isForeignFunction(Dictionary::parse(std::string("type ") + word + ";"))) << word;
    for (const char* word : {"prob", "Probes", "force", "massLeger", "enrgy", "waveGuage", "fieldMinmax", "lines"}) {
        EXPECT_FALSE(isForeignFunction(Dictionary::parse(std::string("type ") + word + ";"))) << word;
        EXPECT_THROW(make(std::string("functions { a { type ") + word + "; } }"), UserError) << word;
    }
}

}  // namespace pfem
