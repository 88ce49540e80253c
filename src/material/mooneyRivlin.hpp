#pragma once
// Mooney-Rivlin rubber: W_iso = C10 (I1 - 3) + C01 (I2 - 3); C01 = 0: the nearly incompressible neo-Hookean solid.

#include "material/decoupledLaw.hpp"

namespace pfem {

class MooneyRivlin : public DecoupledLaw<MooneyRivlin> {
public:
    double C10 = 0, C01 = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("C10", C10, "Pa", "of the first invariant", positive);
        v.required("C01", C01, "Pa", "of the second invariant", nonNegative);
        volumeEntries(v);
    }
    double shearModulus() const { return 2 * (C10 + C01); }
    Tensor<3> shear(const Tensor<3>& F) const { return Isochoric(F).stress(C10, C01); }
    double energy(const Tensor<3>& F) const {
        const Isochoric iso(F);
        return C10 * (iso.I1 - 3) + C01 * (iso.I2 - 3);
    }
};

}  // namespace pfem
