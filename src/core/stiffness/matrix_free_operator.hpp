// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/stiffness/elastic_material.hpp"
#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/node_field.hpp"

namespace lamina {

/// Elements and their material.
struct ElasticElements {
  const ElementLattice& lattice;
  ElasticMaterial material;
  double element_mm = 0.0;  ///< edge length of an element
};

/// Adds `factor` times the forces [N] that belong to the displacements [mm] of the nodes: the product with
/// the stiffness matrix of all elements, which is never stored. The stiffness of a cube with eight nodes,
/// integrated exactly, is almost diagonal in the products of 1, x, y and z of which its displacements consist
/// (the Hadamard transform of its corners), and neighbours along x share half of that transform.
///
/// The sum does not depend on the number of threads.
template <class Real>
void addForces(const ElasticElements& elements, double factor, const NodeField<Real>& displacement,
               NodeField<Real>& force);

/// The diagonal entry of the stiffness matrix [N/mm] of an element of density 1; all its diagonal entries are
/// equal.
double diagonalOfElement(const ElasticMaterial& material, double element_mm);

/// Sum of the densities of the elements around each node: the diagonal of the stiffness matrix of all
/// elements, for each of x, y and z, divided by the diagonal entry of one element.
std::vector<float> densityAround(const ElementLattice& lattice);

}  // namespace lamina
