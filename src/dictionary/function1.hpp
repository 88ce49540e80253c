#pragma once
// Values that depend on time, in OpenFOAM's words:
//
//     displacement  (0.1 0 0);                            // or: constant (0.1 0 0)
//     displacement  table ((0 (0 0 0)) (0.5 (0 0.3 0)));  // straight between the points, constant outside
//     displacement  polynomial (((1 0 0) (2 2 2)));       // sum of coefficient * t^exponent, by component
//     displacement  expression ("0.1*sin(2*pi*t)" "0" "0");
//     displacement  { type sine; frequency 2; scale (0.1 0 0); }
//     displacement  { type waveMaker; theory secondOrder; depth 0.4; height 0.1; period 1.5; }
//
// Types: constant, table, tableFile, polynomial, sine, square, scale, expression, waveMaker (waves/makerSignal.hpp).

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "dictionary/dictionary.hpp"

namespace pfem {

/// A function of time t [s] with values T: double or Eigen::Vector3d.
template <class T>
class Function1 {
public:
    virtual ~Function1() = default;
    virtual T value(double t) const = 0;
    /// df/dt; of the piece that follows where it jumps. The base class takes differences.
    virtual T derivative(double t) const;
    /// Integral of f over [from, to]. The base class sums Gauss points.
    virtual T integral(double from, double to) const;
    /// A z component other than zero that the function has, of a formula at one of some times; 0: there is none.
    virtual double outOfPlane() const = 0;
    /// Given as one value: it never changes. False says nothing.
    virtual bool isConstant() const { return false; }
};

template <class T>
using Function1Ptr = std::shared_ptr<const Function1<T>>;

/// The entry `key` of `dict`. UserError with the entry's line for unknown types and values that make no sense.
template <class T>
Function1Ptr<T> readFunction1(const Dictionary& dict, const std::string& key);

/// The same in a plane case: UserError for a z component that is not zero, which nothing would heed.
Function1Ptr<Eigen::Vector3d> readPlaneFunction1(const Dictionary& dict, const std::string& key);

/// UserError at `key` unless z is 0.
void demandPlane(const Dictionary& dict, const std::string& key, double z);

std::vector<std::string> function1Types();

}  // namespace pfem
