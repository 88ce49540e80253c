#pragma once
// Formulas in dictionaries: #eval, and functions of time and place. Nothing is ever compiled or executed.
//
//     Expression wave("0.1*sin(2*pi*x - t)", {"x", "t"}, where);
//     const double height = wave({0.5, 1.0});

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace pfem {

/// A scalar formula of named variables. Not to be shared between threads: each takes its own copy.
class Expression {
public:
    /// UserError at `where` for what is no formula.
    Expression(const std::string& text, std::vector<std::string> variables, Location where);
    Expression(const Expression& other);
    Expression& operator=(const Expression&) = delete;
    ~Expression();

    /// UserError if the value is not finite.
    double operator()(const std::vector<double>& values) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

double evaluateScalar(const std::string& text, const Location& where);

/// Of a formula with vectors (1 0 0) or vector(1, 0, 0): + - , product with scalars, & dot, ^ cross, mag().
/// The result is a vector, or a scalar in [0] with `isVector` false.
struct EvaluatedVector {
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    bool isVector = false;
};
EvaluatedVector evaluateVector(const std::string& text, const Location& where);

/// True if the formula contains a vector.
bool containsVector(const std::string& text);

/// Scalar or vector, as text for a dictionary: "6", "0.1", "(1 0 0)".
std::string evaluateToText(const std::string& text, const Location& where);

}  // namespace pfem
