#pragma once
// Yeoh's rubber, which stiffens at large stretch: W_iso = C1 (I1 - 3) + C2 (I1 - 3)^2 + C3 (I1 - 3)^3.

#include "material/decoupledLaw.hpp"

namespace pfem {

class Yeoh : public DecoupledLaw<Yeoh> {
public:
    double C1 = 0, C2 = 0, C3 = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("C1", C1, "Pa", "half the shear modulus", positive);
        v("C2", C2, "Pa", "of the square; often negative");
        v("C3", C3, "Pa", "of the cube", nonNegative);
        volumeEntries(v);
    }
    double shearModulus() const { return 2 * C1; }
    Tensor<3> shear(const Tensor<3>& F) const {
        const Isochoric iso(F);
        const double i = iso.I1 - 3;
        return iso.stress(C1 + i * (2 * C2 + 3 * C3 * i), 0);
    }
    double energy(const Tensor<3>& F) const {
        const double i = Isochoric(F).I1 - 3;
        return i * (C1 + i * (C2 + i * C3));
    }
};

}  // namespace pfem
