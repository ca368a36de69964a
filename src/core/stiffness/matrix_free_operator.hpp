// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/stiffness/elastic_material.hpp"
#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/node_field.hpp"

namespace lamina {

/// Elements and what they are made of.
struct ElasticElements {
  const ElementLattice& lattice;
  ElasticMaterial material;
  double element_mm = 0.0;  ///< side of an element
};

/// Adds `factor` times the forces [N] that hold the displacements [mm] of the nodes: the product with the
/// stiffness of all elements, none of which is ever held. The stiffness of a cube with eight nodes,
/// integrated exactly, is almost diagonal in the products of 1, x, y and z that its displacements are made of
/// (the Hadamard transform of its corners), and neighbours along x share half of that transform.
///
/// The sum comes out the same whatever the number of threads.
template <class Real>
void addForces(const ElasticElements& elements, double factor, const NodeField<Real>& displacement,
               NodeField<Real>& force);

/// Every number on the diagonal of the stiffness [N/mm] of an element of density 1.
double diagonalOfElement(const ElasticMaterial& material, double element_mm);

/// Sum of the densities of the elements around each node: the diagonal of the stiffness of all of them, along
/// x, y and z alike, over that of one.
std::vector<float> densityAround(const ElementLattice& lattice);

}  // namespace lamina
