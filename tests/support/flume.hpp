#pragma once
// A flume with what moves the water at its left end, and its waves as complex amplitudes.

#include <complex>

#include "functions/waveGauge.hpp"
#include "support/cases.hpp"

namespace pfem::test {

/// The text with the values in the places of its %.
inline std::string numbers(const std::string& text, const std::vector<double>& values) {
    std::string result;
    std::size_t k = 0;
    for (const char c : text) result += c == '%' ? std::to_string(values.at(k++)) : std::string(1, c);
    return result;
}

inline double elevation(const TestCase& c, double x, double d) {
    return readGauge<2>(c.state, {x, 0}, {0, 1})->elevation - d;
}

/// Complex amplitudes of the multiples of omega at the places, over whole periods T from the case's time on.
inline std::vector<std::vector<std::complex<double>>> harmonics(TestCase& c, const std::vector<double>& x, double d,
                                                                double T, int periods) {
    constexpr int perPeriod = 60, nHarmonics = 2;
    std::vector<std::vector<std::complex<double>>> A(nHarmonics, std::vector<std::complex<double>>(x.size()));
    for (int n = 0; n < perPeriod * periods; ++n) {
        c.step(T / perPeriod);
        for (std::size_t m = 0; m < x.size(); ++m)
            for (int k = 1; k <= nHarmonics; ++k)
                A[k - 1][m] += 2.0 / (perPeriod * periods) * elevation(c, x[m], d) *
                               std::polar(1.0, -2 * M_PI * k * c.state.time.value / T);
    }
    return A;
}

}  // namespace pfem::test
