#pragma once
// The types of Function1 and how each is read. Internal to src/dictionary.

#include <utility>

#include "dictionary/expression.hpp"
#include "dictionary/function1.hpp"

namespace pfem::function1Detail {

inline double zOf(double) { return 0; }
inline double zOf(const Eigen::Vector3d& v) { return v[2]; }

template <class T>
class Constant : public Function1<T> {
public:
    explicit Constant(T value) : value_(std::move(value)) {}
    T value(double) const override { return value_; }
    T derivative(double) const override { return 0 * value_; }
    T integral(double from, double to) const override { return (to - from) * value_; }
    double outOfPlane() const override { return zOf(value_); }
    bool isConstant() const override { return true; }

private:
    T value_;
};

enum class OutOfBounds { clamp, repeat, error };

template <class T>
using Pairs = std::vector<std::pair<double, T>>;

/// Straight lines between points.
template <class T>
class Table1 : public Function1<T> {
public:
    /// UserError at `where` unless there is a point and the times ascend.
    Table1(Pairs<T> points, OutOfBounds outside, Location where);
    T value(double t) const override;
    T derivative(double t) const override;
    T integral(double from, double to) const override;
    double outOfPlane() const override;

private:
    double within(double t) const;
    std::size_t piece(double t) const;
    T integralFromFirst(double t) const;

    Pairs<T> points_;
    OutOfBounds outside_;
    Location where_;
    std::vector<T> area_;  // integral from the first point to each one
};

/// sum_k c_k t^(e_k), by component.
template <class T>
class Polynomial : public Function1<T> {
public:
    explicit Polynomial(std::vector<std::pair<T, T>> terms) : terms_(std::move(terms)) {}
    T value(double t) const override { return sum(t, 0); }
    T derivative(double t) const override { return sum(t, 1); }
    T integral(double from, double to) const override { return sum(to, -1) - sum(from, -1); }
    double outOfPlane() const override;

private:
    T sum(double t, int order) const;

    std::vector<std::pair<T, T>> terms_;  // coefficients and exponents
};

/// level + scale amplitude(t) w(frequency (t - start)); w: a sine, or +1 and -1 in the ratio markSpace.
template <class T>
struct WaveEntries {
    double frequency = 1, start = 0, markSpace = 1;
    Function1Ptr<double> amplitude;
    T scale, level;
    bool square = false;
};

template <class T>
class Wave : public Function1<T> {
public:
    explicit Wave(WaveEntries<T> entries) : e_(std::move(entries)) {}
    T value(double t) const override;
    T derivative(double t) const override;
    double outOfPlane() const override { return zOf(e_.scale) != 0 ? zOf(e_.scale) : zOf(e_.level); }

private:
    WaveEntries<T> e_;
};

template <class T>
class Scale : public Function1<T> {
public:
    Scale(Function1Ptr<double> factor, Function1Ptr<T> f) : factor_(std::move(factor)), f_(std::move(f)) {}
    T value(double t) const override { return factor_->value(t) * f_->value(t); }
    T derivative(double t) const override {
        return factor_->derivative(t) * f_->value(t) + factor_->value(t) * f_->derivative(t);
    }
    double outOfPlane() const override { return f_->outOfPlane(); }

private:
    Function1Ptr<double> factor_;
    Function1Ptr<T> f_;
};

/// One formula of t per component.
template <class T>
class Formula : public Function1<T> {
public:
    Formula(const std::vector<std::string>& formulas, const Location& where);
    T value(double t) const override;
    double outOfPlane() const override;

private:
    std::vector<Expression> components_;
};

template <class T>
Pairs<T> readPairs(TokenReader& tokens);
template <class T>
std::vector<std::pair<T, T>> readTerms(TokenReader& tokens);
template <class T>
std::vector<std::string> readFormulas(TokenReader& tokens);
template <class T>
WaveEntries<T> readWave(const Dictionary& dict, bool square);
template <class T>
Function1Ptr<T> readMakerMotion(const Dictionary& dict);
template <class T>
Pairs<T> readTableFile(const Dictionary& dict);
OutOfBounds readOutOfBounds(const Dictionary& dict);

}  // namespace pfem::function1Detail
