#pragma once
// Ogden's rubber in principal stretches: W_iso = sum_k mu_k/alpha_k (l1^alpha_k + l2^alpha_k + l3^alpha_k - 3) with
// l_i = J^(-1/3) lambda_i; alpha 2: neo-Hookean, 2 and -2: Mooney-Rivlin.

#include "base/spectrum.hpp"
#include "material/decoupledLaw.hpp"

namespace pfem {

class Ogden : public DecoupledLaw<Ogden> {
public:
    std::vector<double> mu, alpha;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("mu", mu, "Pa", "moduli of the terms; mu_k alpha_k > 0");
        v.required("alpha", alpha, "-", "exponents of the terms, as many");
        volumeEntries(v);
    }
    /// What is wrong with the entries, empty when nothing is.
    std::string fault() const {
        if (mu.empty() || mu.size() != alpha.size())
            return "'mu' and 'alpha' must have equally many numbers, at least one";
        for (std::size_t k = 0; k < mu.size(); ++k)
            if (!(mu[k] * alpha[k] > 0)) return "each product of 'mu' and 'alpha' must be positive";
        return "";
    }
    double shearModulus() const {
        double sum = 0;
        for (std::size_t k = 0; k < mu.size(); ++k) sum += 0.5 * mu[k] * alpha[k];
        return sum;
    }
    Tensor<3> shear(const Tensor<3>& F) const {
        const Isochoric iso(F);
        const auto eigen = spectrum<3>(iso.b);
        Vec<3> t = Vec<3>::Zero();  // l_i dW/dl_i
        for (std::size_t k = 0; k < mu.size(); ++k) t += mu[k] * eigen.values.array().pow(0.5 * alpha[k]).matrix();
        t.array() -= t.mean();
        return eigen.vectors * (t / iso.J).asDiagonal() * eigen.vectors.transpose();
    }
    double energy(const Tensor<3>& F) const {
        const Vec<3> squares = eigenvalues<3>(Isochoric(F).b);
        double sum = 0;
        for (std::size_t k = 0; k < mu.size(); ++k)
            sum += mu[k] / alpha[k] * (squares.array().pow(0.5 * alpha[k]).sum() - 3);
        return sum;
    }
};

}  // namespace pfem
