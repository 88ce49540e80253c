#pragma once
// What the laws of von Mises plasticity share: elastic constants, hardening, their entries.

#include "material/elasticity.hpp"
#include "material/hardening.hpp"

namespace pfem {

/// Base: RateLaw or HyperelasticLaw.
template <template <class> class Base, class Law>
class J2Law : public Base<Law> {
public:
    IsotropicElasticity elastic;
    Hardening hardening;

    template <class Visitor>
    void entries(Visitor& v) {
        elastic.entries(v);
        hardening.entries(v);
    }
    std::string fault() const { return hardening.fault(); }
    IsotropicElasticity elasticity() const override { return elastic; }
};

}  // namespace pfem
