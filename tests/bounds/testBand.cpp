#include <gtest/gtest.h>

#include "base/error.hpp"
#include "bounds/report.hpp"
#include "curves.hpp"

namespace pfem {
namespace {

using namespace test;

double part(const Study& study, const Band& band, Bracket b) { return fractionWhere(study.t, band.where(b)); }

// 1 + cos: from 2 to 0 and back; a constant factor between the curves keeps their order.
TEST(Band, brackets) {
    const Study study = powerLaw(
        times(2 * M_PI, 400), [](double t) { return 1 - std::cos(t); }, {0.5}, 0.4, 0.2, 1);
    const Band band = makeBand(study);
    EXPECT_GT(part(study, band, Bracket::holds), 0.9);
    EXPECT_NEAR(part(study, band, Bracket::holds) + part(study, band, Bracket::none), 1, 1e-12);
    EXPECT_NEAR(band.range, 2 * 1.2, 1e-12);
    EXPECT_TRUE(crossings(study, band).empty());
    const Width width = widthOf(study, band);
    EXPECT_NEAR(width.largest, 2 * 0.3, 1e-9);
    EXPECT_NEAR(width.mean, 0.3, 1e-9);
    EXPECT_NEAR(width.when, M_PI, 1e-9);
}

// Downwards it is the nodal curve that is the lower one: still a bracket.
TEST(Band, bracketsDownwards) {
    const Study study = powerLaw(
        times(1, 100), [](double t) { return -t; }, {1}, 0.1, 0.1, 1);
    const Band band = makeBand(study);
    EXPECT_EQ(band.lower.back(), study.twins[0].nodal.back());
    EXPECT_EQ(band.bracket.back(), Bracket::holds);
}

// The rest state may be any number; what counts is the change.
TEST(Band, measuresFromTheFirstValue) {
    const Study study = pair(
        times(1, 10), [](double t) { return 5 - 1.1 * t; }, [](double t) { return 5 - t; });
    EXPECT_EQ(makeBand(study).bracket.back(), Bracket::holds);
    const Study wrong = pair(
        times(1, 10), [](double t) { return 5 - t; }, [](double t) { return 5 - 1.1 * t; });
    EXPECT_EQ(makeBand(wrong).bracket.back(), Bracket::reversed);
}

// A softer spring swings more slowly: sin(w t) of two frequencies cross at t = (n pi)/(w1 + w2) (n odd).
TEST(Band, crossingsOfTwoFrequencies) {
    const Study study = pair(
        times(6, 6000), [](double t) { return std::sin(0.9 * t); }, [](double t) { return std::sin(t); });
    const Band band = makeBand(study);
    const auto times = crossings(study, band);
    ASSERT_EQ(times.size(), 2u);  // the first is at pi/1.9, then 3 pi/1.9 (the start itself is no crossing)
    EXPECT_NEAR(times[0], M_PI / 1.9, 2e-3);
    EXPECT_NEAR(times[1], 3 * M_PI / 1.9, 2e-3);
    // in between the nodal curve is ahead; before, it is behind: reversed until the first crossing
    const auto reversed = spansWhere(study.t, band.where(Bracket::reversed));
    ASSERT_FALSE(reversed.empty());
    EXPECT_NEAR(reversed[0].to, M_PI / 1.9, 0.02);  // less what is too narrow
    // while sin(0.9 t) > 0 > sin(t) they are on different sides of rest
    const std::size_t k = 3300;  // t = 3.3
    EXPECT_EQ(band.bracket[k], Bracket::reversed);
    EXPECT_EQ(band.bracket[2000], Bracket::holds);
}

TEST(Band, leavesTheCoarserOne) {
    Study study = powerLaw(
        times(1, 100), [](double t) { return t; }, {1, 0.5}, 0.2, 0.2, 1);
    EXPECT_EQ(makeBand(study).bracket.back(), Bracket::holds);
    for (double& y : study.twins[1].nodal) y *= 1.2;  // 1.32 against 1.2 of the coarse mesh
    const Band band = makeBand(study);
    EXPECT_EQ(band.bracket.back(), Bracket::leaves);
    EXPECT_GT(part(study, band, Bracket::leaves), 0.9);
}

TEST(Band, missingValues) {
    Study study = powerLaw(
        times(1, 100), [](double t) { return t; }, {1}, 0.2, 0.2, 1);
    for (std::size_t i = 50; i < 101; ++i) study.twins[0].elemental[i] = NAN;
    const Band band = makeBand(study);
    EXPECT_NEAR(part(study, band, Bracket::missing), 0.505, 1e-9);
    EXPECT_EQ(band.bracket[49], Bracket::holds);
    EXPECT_NEAR(band.range, 1.2, 1e-12);
    EXPECT_THROW(makeBand({{}, study.twins}), UserError);
}

TEST(Band, containmentOfAReference) {
    const auto t = times(4, 4000);
    const Study study = pair(
        t, [](double) { return 1.0; }, [](double) { return 0.0; });
    const Band band = makeBand(study);
    std::vector<double> reference;
    for (const double now : t) reference.push_back(now < 3.5 ? 0.5 * now - 0.25 : NAN);  // inside from 0.5 to 2.5
    const Containment c = containment(t, band, reference);
    EXPECT_NEAR(c.compared, 3.5 / 4, 1e-3);
    EXPECT_NEAR(c.inside, 2.0 / 3.5, 1e-3);
    EXPECT_NEAR(c.farthest, 0.5, 1e-3);
    EXPECT_NEAR(c.when, 3.5, 2e-3);
    ASSERT_EQ(c.outside.size(), 2u);
    EXPECT_NEAR(c.outside[1].from, 2.5, 2e-3);
    EXPECT_NEAR(containment(t, band, reference, 0.25).inside, 3 / 3.5, 1e-3);
}

TEST(Report, saysWhereTheBandDoesNotHold) {
    Quantity q;
    q.name = "tip_D_x";
    q.study = pair(
        times(6, 6000), [](double t) { return std::sin(0.9 * t); }, [](double t) { return std::sin(t); });
    q.band = makeBand(q.study);
    q.limit = estimate(q.study, q.band);
    const std::string text = reportOf(q);
    EXPECT_NE(text.find("NO BRACKET"), std::string::npos) << text;
    EXPECT_NE(text.find("cross 2 times, first at 1.65"), std::string::npos) << text;
    EXPECT_NE(text.find("no estimate: one mesh size only"), std::string::npos) << text;
    q.study = powerLaw(
        times(1, 100), [](double t) { return t; }, {1}, 2, 0.9, 1);  // 3 against 0.1
    q.band = makeBand(q.study);
    EXPECT_EQ(reportOf(q).find("NO BRACKET"), std::string::npos);
    EXPECT_EQ(reportOf(q).find("TOO COARSE"), std::string::npos);  // 48 % in the mean
    q.study = powerLaw(
        times(1, 100), [](double t) { return t; }, {1}, 2, 1, 1);
    for (double& y : q.study.twins[0].elemental) y = 0;
    for (double& y : q.study.twins[0].nodal) y = 2 - 2 * (y < 1e-9);
    q.band = makeBand(q.study);
    EXPECT_NE(reportOf(q).find("TOO COARSE"), std::string::npos) << reportOf(q);
}

TEST(Report, spansAndMeshes) {
    EXPECT_EQ(spansText({{0, 1}, {2, 2.5}}), "0 - 1, 2 - 2.5 s");
    EXPECT_EQ(spansText({{0, 1}, {2, 2.1}, {3, 4}, {5, 6}, {7, 8}}), "0 - 1, 3 - 4, 5 - 6, 7 - 8 s; 5 spans in all");
    EXPECT_EQ(unlikeMeshes({2, 1, 0.5}, {100, 390, 1620}), "");
    EXPECT_NE(unlikeMeshes({2, 1}, {100, 290}), "");
    EXPECT_NE(unlikeMeshes({2, 1}, {100, 510}), "");
}

}  // namespace
}  // namespace pfem
