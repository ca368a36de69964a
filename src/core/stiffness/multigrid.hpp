// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/stiffness/node_field.hpp"
#include "stiffness/coarse_factor.hpp"
#include "stiffness/matrix_free_operator.hpp"

namespace lamina {

/// One lattice of a multigrid, and what is held on it.
struct MultigridLevel {
  ElasticElements elements;
  GivenNodes given;
  float greatest_eigenvalue = 0.0F;     ///< of the stiffness divided by its diagonal, about
  std::vector<float> inverse_diagonal;  ///< [mm/N]
  NodeField<float> residual;
  NodeField<float> solution;
  NodeField<float> step;
};

/// An approximate inverse of the stiffness of a lattice: one cycle over lattices twice as coarse each, whose
/// elements carry the mean density of what they cover; the finest is visited once, the others twice as often
/// as the one above. Smoothed by Chebyshev polynomials of the fourth kind
/// [Lottes2023], solved by factors at the coarsest. Symmetric, in single
/// precision.
class Multigrid {
 public:
  /// @param elements  their lattice outlives the multigrid
  /// @param given     components of nodes that stay 0
  Multigrid(const ElasticElements& elements, const GivenNodes& given);

  /// Roughly the displacement that `scale` times a force causes.
  /// @param force  0 where displacements are given
  const NodeField<float>& operator()(const NodeField<double>& force, double scale);

 private:
  void addLevel(const ElasticElements& elements, GivenNodes given);
  void solve(std::size_t at);
  void correct(std::size_t at);

  std::vector<std::unique_ptr<const ElementLattice>> coarser_;
  std::vector<MultigridLevel> levels_;
  std::unique_ptr<const CoarseFactor> coarsest_;
};

}  // namespace lamina
