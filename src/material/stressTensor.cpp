#include "material/stressTensor.hpp"

namespace pfem {

template <int Dim>
Tensor<Dim> stressTensor(const Stress<Dim>& s) {
    Tensor<Dim> t;
    if constexpr (Dim == 2)
        t << s[0], s[3], s[3], s[1];
    else
        t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    return t;
}

template <int Dim>
Stress<Dim> packStress(const Tensor<Dim>& t, double zz) {
    Stress<Dim> s;
    if constexpr (Dim == 2)
        s << t(0, 0), t(1, 1), zz, t(0, 1);
    else
        s << t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2);
    return s;
}

template <int Dim>
double pressure(const Stress<Dim>& sigma) {
    return -(sigma[0] + sigma[1] + sigma[2]) / 3;
}

template <int Dim>
Stress<Dim> withPressure(const Stress<Dim>& s, double p) {
    Stress<Dim> sigma = s;
    for (int c = 0; c < 3; ++c) sigma[c] -= p;
    return sigma;
}

template <int Dim>
Stress<Dim> deviator(const Stress<Dim>& sigma) {
    return withPressure<Dim>(sigma, -pressure<Dim>(sigma));
}

template <int Dim>
Tensor<3> inSpace(const Tensor<Dim>& t, double zz) {
    Tensor<3> full = Tensor<3>::Zero();
    full(2, 2) = zz;
    full.template topLeftCorner<Dim, Dim>() = t;
    return full;
}

template <int Dim>
Stress<Dim> stored(const Tensor<3>& sigma) {
    return packStress<Dim>(sigma.template topLeftCorner<Dim, Dim>(), sigma(2, 2));
}

#define PFEM_INSTANTIATE(D)                                       \
    template Tensor<D> stressTensor<D>(const Stress<D>&);         \
    template Stress<D> packStress<D>(const Tensor<D>&, double);   \
    template double pressure<D>(const Stress<D>&);                \
    template Stress<D> deviator<D>(const Stress<D>&);             \
    template Stress<D> withPressure<D>(const Stress<D>&, double); \
    template Tensor<3> inSpace<D>(const Tensor<D>&, double);      \
    template Stress<D> stored<D>(const Tensor<3>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
