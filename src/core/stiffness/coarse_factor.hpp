// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "lamina/stiffness/node_field.hpp"
#include "stiffness/matrix_free_operator.hpp"

namespace lamina {

/// The stiffness of a small lattice, held and factored.
class CoarseFactor {
 public:
  CoarseFactor(const ElasticElements& elements, const GivenNodes& given);
  ~CoarseFactor();
  CoarseFactor(CoarseFactor&&) noexcept;
  CoarseFactor& operator=(CoarseFactor&&) noexcept;

  /// The displacement that a force causes; 0 where it is given.
  void solve(const NodeField<float>& force, NodeField<float>& displacement) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace lamina
