// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A quantity along a path, from its values at the waypoints: a single value if they are all the same.
template <class Value, class IsSame>
AlongPath<Value> alongPath(std::vector<Value> values, const IsSame& is_same) {
  const bool is_common = std::all_of(values.begin(), values.end(),
                                     [&](const Value& value) { return is_same(value, values.front()); });
  if (is_common) return values.front();
  return AlongPath<Value>(std::move(values));
}

/// The orientation of the nozzle along a path, from its values at the waypoints; a single value if they are
/// all the same.
inline AlongPath<Eigen::Quaterniond> heldAlong(std::vector<Eigen::Quaterniond> orientations) {
  constexpr double kSameTurn = 1e-9;
  return alongPath(std::move(orientations), [](const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    return (a.coeffs() - b.coeffs()).norm() < kSameTurn;
  });
}

}  // namespace lamina
