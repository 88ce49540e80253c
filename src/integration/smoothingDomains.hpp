#pragma once
// Smoothing domains of the nodes (13)-(17), (20)-(21), the patches of the paper: volume and gradients of every node in
// ONE material.
//
// Omega_I = sum_e |e|/(d+1),   Omega_I G_IJ = sum_e |e|/(d+1) grad N_J^e   over the elements e around I.
// The gradient rows are never stored: every operator below is one pass over elements and one over nodes, each
// node gathering from its own elements, so that the bits do not depend on the number of threads.

#include <vector>

#include "base/types.hpp"
#include "integration/fields.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/simplex.hpp"
#include "parallel/share.hpp"

namespace pfem {

/// Where stress lives: at the nodes, each with the mean of its patch, or in the elements.
enum class Integration { nodal, elemental };

/// Of a cell. New ones in arrays are not set to zero (as those of SimplexGeometry would be): threads set them.
template <int Dim>
struct CellGeometry : SimplexGeometry<Dim> {
    CellGeometry();
    CellGeometry(const SimplexGeometry<Dim>& g) : SimplexGeometry<Dim>(g) {}
};
template <int Dim>
CellGeometry<Dim>::CellGeometry() = default;

template <int Dim>
struct SmoothingDomains {
    const std::vector<Simplex<Dim>>* cells = nullptr;
    const NodeToCells* around = nullptr;
    PerCell<CellGeometry<Dim>> element;
    PerNode<double> volume;                   // Omega_I [m2 (2D), m3]; 0 outside the material
    Integration scheme = Integration::nodal;  // which of them are stress points (stressPoints.hpp)
    Share share;                              // of all loops: beyond it numbers are old ones or none

    int nNodes() const { return static_cast<int>(volume.size()); }
    int nCells() const { return static_cast<int>(element.size()); }
    const Simplex<Dim>& cell(int e) const { return (*cells)[e]; }
};

/// Patches over `cells` (kept by reference), evaluated at the positions x.
template <int Dim>
SmoothingDomains<Dim> makeSmoothingDomains(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around,
                                           const Points<Dim>& x, Integration scheme = Integration::nodal,
                                           const Share& share = {});

/// Volumes and gradients in the configuration x.
template <int Dim>
void updateSmoothingDomains(SmoothingDomains<Dim>& domains, const Points<Dim>& x);

/// Volumes of the nodes from those of the elements.
template <int Dim>
void updateVolumes(SmoothingDomains<Dim>& domains);

/// grad v in an element: L_ij = dv_i/dx_j.
template <int Dim>
Tensor<Dim> gradientIn(const SimplexGeometry<Dim>& element, const Simplex<Dim>& nodes, const Points<Dim>& v) {
    Tensor<Dim> sum = Tensor<Dim>::Zero();
    for (int k = 0; k <= Dim; ++k) sum += v[nodes[k]] * element.gradN[k].transpose();
    return sum;
}

/// The same in every element.
template <int Dim>
PerCell<Tensor<Dim>> elementGradient(const SmoothingDomains<Dim>& domains, const Points<Dim>& v);

/// Nodal mean of an element field: (1/Omega_I) sum_e |e|/(d+1) f_e; zero outside the material. With
/// f = grad v this is L_I = sum_J v_J (x) G_IJ. Value: Tensor or Stress.
template <int Dim, class Value>
PerNode<Value> nodalMean(const SmoothingDomains<Dim>& domains, const PerCell<Value>& field);

/// force_J += sum_e |e| S_e grad N_J: the nodal force that balances the element stress S.
template <int Dim>
void addInternalForce(const SmoothingDomains<Dim>& domains, const PerCell<Tensor<Dim>>& stress, Points<Dim>& force);

/// force_J -= sum_e |e| p_e grad N_J with p_e the mean of the cell's nodes: the force of a pressure.
template <int Dim>
void addPressureForce(const SmoothingDomains<Dim>& domains, const PerNode<double>& p, Points<Dim>& force);

/// Element stress that makes addInternalForce equal to sum_I Omega_I sigma_I G_IJ: the mean of the cell's nodes.
/// Value: Tensor, Stress or double.
template <int Dim, class Value>
PerCell<Value> elementMean(const SmoothingDomains<Dim>& domains, const PerNode<Value>& nodal);

/// The gradients of a velocity in the elements, and their means at the nodes.
template <int Dim>
struct VelocityGradients {
    PerCell<Tensor<Dim>> element;
    PerNode<Tensor<Dim>> nodal;
};

template <int Dim>
VelocityGradients<Dim> velocityGradients(const SmoothingDomains<Dim>& domains, const Points<Dim>& v) {
    auto element = elementGradient<Dim>(domains, v);
    auto nodal = nodalMean<Dim>(domains, element);
    return {std::move(element), std::move(nodal)};
}

}  // namespace pfem
