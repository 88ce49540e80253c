#include "../io/sampleState.hpp"
#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "base/error.hpp"
#include "io/stateFiles.hpp"

namespace pfem {

using namespace test;

namespace {

OptionsSpec testSpec() {
    OptionsSpec spec;
    spec.addTimeSelection().add("fields", "list", "Fields to sample").add("overwrite", "", "Replace");
    return spec;
}

Options parse(std::vector<const char*> arguments, const OptionsSpec& spec = testSpec()) {
    arguments.insert(arguments.begin(), "/some/where/pfemTest");
    return Options(static_cast<int>(arguments.size()), arguments.data(), spec);
}

std::string errorOf(const std::vector<const char*>& arguments) {
    try {
        parse(arguments);
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

int runWith(std::vector<const char*> arguments, const std::function<int(const Options&)>& body) {
    arguments.insert(arguments.begin(), "pfemTest");
    return runApplication(static_cast<int>(arguments.size()), arguments.data(), "A test.", testSpec(), body);
}

}  // namespace

TEST(Options, SingleDashLongOptions) {
    const Options options = parse({"-case", "/tmp", "-time", "-1:2", "-fields", "(U p)", "-latestTime"});
    EXPECT_EQ(options.program(), "pfemTest");
    EXPECT_EQ(options.get("case"), "/tmp");
    EXPECT_EQ(options.get("time"), "-1:2");
    EXPECT_EQ(options.get("fields"), "(U p)");
    EXPECT_TRUE(options.found("latestTime"));
    EXPECT_FALSE(options.found("noZero"));
    EXPECT_EQ(options.get("noZero", "x"), "x");
    EXPECT_EQ(parse({"-case=/tmp"}).get("case"), "/tmp");
    EXPECT_EQ(parse({"--case", "/tmp"}).get("case"), "/tmp");
    EXPECT_EQ(parse({"-time", "0.1"}).get("time"), "0.1");
    EXPECT_TRUE(parse({"-help"}).found("help"));
}

TEST(Options, Mistakes) {
    EXPECT_EQ(errorOf({"-foo"}), "Invalid option: -foo");
    EXPECT_EQ(errorOf({"--foo"}), "Invalid option: -foo");
    EXPECT_EQ(errorOf({"-latestTim"}), "Invalid option: -latestTim (did you mean '-latestTime'?)");
    EXPECT_EQ(errorOf({"-case", "/tmp", "-foo"}), "Invalid option: -foo");
    EXPECT_EQ(errorOf({"-case"}), "Option -case requires an argument");
    EXPECT_EQ(errorOf({"-latestTime=3"}), "Option -latestTime takes no argument");
    EXPECT_EQ(errorOf({"stray"}), "Expected 0 arguments but found 1: 'stray'");
    EXPECT_EQ(errorOf({"-c", "/tmp"}), "Invalid option: -c");
}

TEST(Options, PositionalArguments) {
    OptionsSpec spec;
    spec.arguments = {"file"};
    EXPECT_EQ(parse({"some/file", "-case", "."}, spec).arguments(), std::vector<std::string>{"some/file"});
    EXPECT_THROW(parse({}, spec), UserError);
    EXPECT_THROW(parse({"-foo"}, spec), UserError);
}

TEST(Options, HelpInTwoColumns) {
    const std::string help = helpText("pfemTest", "A test.", testSpec());
    EXPECT_NE(help.find("Usage: pfemTest [OPTIONS]\nOptions:\n  -case <dir>       Specify"), std::string::npos) << help;
    EXPECT_NE(help.find("\n  -help             Display"), std::string::npos) << help;
    EXPECT_EQ(help.find("--"), std::string::npos) << help;
    EXPECT_NE(help.find("Using: libpfem-"), std::string::npos);
}

TEST(RunApplication, ErrorsBecomeExitCodes) {
    const TemporaryFolder folder;
    const std::string path = folder.path().string();
    EXPECT_EQ(runWith({"-case", path.c_str()}, [](const Options& o) { return o.openCase().root().empty() ? 3 : 0; }),
              0);
    testing::internal::CaptureStderr();
    EXPECT_EQ(runWith({"-case", "/nonexist"}, [](const Options& o) { return o.openCase().root().empty() ? 3 : 0; }), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "\n\n--> FOAM FATAL ERROR:\npfemTest: cannot open case directory \"/nonexist\"\n\nFOAM exiting\n\n");
    testing::internal::CaptureStderr();
    EXPECT_EQ(runWith({}, [](const Options&) -> int { throw UserError("Entry 'x' not found", {"/c/d", 28}); }), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "\n\n--> FOAM FATAL IO ERROR:\nEntry 'x' not found\n\nfile: /c/d at line 28.\n\nFOAM exiting\n\n");
    for (const auto& thrower : std::vector<std::function<int(const Options&)>>{
             [](const Options&) -> int { throw StepFailure("no convergence"); },
             [](const Options&) -> int { throw InternalError("bug"); },
             [](const Options&) -> int { throw std::bad_alloc(); }}) {
        testing::internal::CaptureStderr();
        EXPECT_EQ(runWith({}, thrower), 1);
        EXPECT_NE(testing::internal::GetCapturedStderr().find("FOAM FATAL ERROR"), std::string::npos);
    }
}

TEST(RunApplication, HelpAndWrongOption) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(runWith({"-help", "-case", "/nonexist"}, [](const Options&) { return 5; }), 0);
    EXPECT_NE(testing::internal::GetCapturedStdout().find("Usage: pfemTest"), std::string::npos);
    EXPECT_EXIT(runWith({"-foo"}, [](const Options&) { return 0; }), testing::ExitedWithCode(1),
                "Invalid option: -foo\nSee 'pfemTest -help' for usage");
}

TEST(StartBanner, HasTheLinesOfALog) {
    const std::string banner = startBanner(parse({"-case", "."}), Case("."));
    for (const char* part : {"Build  : PFEM=", "\nExec   : pfemTest -case .\n", "\nDate   : ", "\nTime   : ",
                             "\nHost   : ", "\nPID    : ", "\nCase   : /", "\nnProcs : 1\n// * * *"})
        EXPECT_NE(banner.find(part), std::string::npos) << part;
}

class TimeSelection : public testing::Test {
protected:
    TimeSelection() {
        for (const char* name : {"0", "0.05", "0.1", "0.15", "0.2"}) writeState(folder_.path() / name, State<2>{});
    }
    std::string select(std::vector<const char*> arguments) const {
        std::string names;
        for (const auto& time : selectTimes(Case(folder_.path()), parse(std::move(arguments))))
            names += time.name + " ";
        return names;
    }
    TemporaryFolder folder_;
};

TEST_F(TimeSelection, Ranges) {
    EXPECT_EQ(select({}), "0 0.05 0.1 0.15 0.2 ");
    EXPECT_EQ(select({"-noZero"}), "0.05 0.1 0.15 0.2 ");
    EXPECT_EQ(select({"-latestTime"}), "0.2 ");
    EXPECT_EQ(select({"-time", "0.05:0.1,0.2:"}), "0.05 0.1 0.2 ");
    EXPECT_EQ(select({"-time", ":0.05 0.15"}), "0 0.05 0.15 ");
    EXPECT_EQ(select({"-time", ":"}), "0 0.05 0.1 0.15 0.2 ");
    EXPECT_EQ(select({"-time", "-1:0.07", "-noZero"}), "0.05 ");
    EXPECT_EQ(select({"-time", ":0.12", "-latestTime"}), "0.1 ");
    EXPECT_THROW(select({"-time", "none"}), UserError);
    EXPECT_THROW(select({"-time", "0.07"}), UserError);
    EXPECT_THROW(select({"-time", "a:b"}), UserError);
}

TEST_F(TimeSelection, IncompleteFoldersAreNamed) {
    std::filesystem::remove(folder_.path() / "0.2/fluid.vtu");
    testing::internal::CaptureStderr();
    EXPECT_EQ(select({"-latestTime"}), "0.15 ");
    EXPECT_NE(testing::internal::GetCapturedStderr().find("0.2 is ignored: fluid.vtu is missing"), std::string::npos);
}

}  // namespace pfem
