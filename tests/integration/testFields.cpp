// Numbers per node, cell and stress point cannot be taken for one another: what must not compile.

#include <gtest/gtest.h>

#include <type_traits>

#include "integration/stressPoints.hpp"

using namespace pfem;

namespace {

template <class From, class To>
constexpr bool converts = std::is_convertible_v<From, To> || std::is_assignable_v<To&, From>;

template <class A, class B>
constexpr bool apart = !converts<A, B> && !converts<B, A>;

static_assert(apart<PerCell<double>, PerPoint<double>>);
static_assert(apart<PerCell<double>, PerNode<double>>);
static_assert(apart<PerPoint<double>, PerNode<double>>);
static_assert(apart<PerCell<Tensor<2>>, PerPoint<Tensor<2>>>);
static_assert(!std::is_constructible_v<PerCell<double>, PerPoint<double>>);
static_assert(!std::is_constructible_v<PerPoint<double>, PerCell<double>>);

// The means lead from one to the other, and only the way they say.
template <class Field>
constexpr bool canBeMeanOfNodes = requires(const SmoothingDomains<2>& d, const Field& f) {
    nodalMean<2>(d, f);
};
template <class Field>
constexpr bool canGoToPoints = requires(const SmoothingDomains<2>& d, const Field& f) {
    toPoints<2>(d, f);
};
static_assert(canBeMeanOfNodes<PerCell<Tensor<2>>>);
static_assert(!canBeMeanOfNodes<PerPoint<Tensor<2>>> && !canBeMeanOfNodes<PerNode<Tensor<2>>>);
static_assert(canGoToPoints<PerCell<Tensor<2>>>);
static_assert(!canGoToPoints<PerPoint<Tensor<2>>> && !canGoToPoints<PerNode<Tensor<2>>>);

}  // namespace

TEST(Fields, costNothing) {
    static_assert(sizeof(PerCell<double>) == sizeof(std::vector<double>));
    std::vector<double> values{1, 2, 3};
    const double* where = values.data();
    PerCell<double> field(std::move(values));
    EXPECT_EQ(field.data(), where);
    EXPECT_EQ(std::move(field).values().data(), where);
}
