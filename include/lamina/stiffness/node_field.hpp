// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lamina {

/// A vector at every node, stored as three arrays of components.
template <class Real>
struct NodeField {
  std::array<std::vector<Real>, 3> along;  ///< components along x, y, z, by node number

  NodeField() = default;
  explicit NodeField(std::int32_t nodes) {
    for (auto& component : along) component.resize(static_cast<std::size_t>(nodes));
  }
  std::size_t size() const { return along[0].size(); }
  std::array<Real*, 3> pointers() { return {along[0].data(), along[1].data(), along[2].data()}; }
  std::array<const Real*, 3> pointers() const { return {along[0].data(), along[1].data(), along[2].data()}; }
};

/// Sets every component at every node to a value.
template <class Real>
void fill(NodeField<Real>& field, Real value) {
  for (auto& component : field.along) component.assign(component.size(), value);
}

/// Numbers of the nodes whose displacement is given (boundary conditions), for each of x, y, z; ascending.
using GivenNodes = std::array<std::vector<std::int32_t>, 3>;

/// Sets the components whose displacement is given to 0.
template <class Real>
void clearGiven(NodeField<Real>& field, const GivenNodes& given) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const std::int32_t node : given[axis]) field.along[axis][static_cast<std::size_t>(node)] = Real{0};
}

}  // namespace lamina
