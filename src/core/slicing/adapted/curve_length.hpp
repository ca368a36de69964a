// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/slicing/adapted/adapted_layers.hpp"
#include "slicing/adapted/curve_places.hpp"

namespace lamina {

/// A curve parameterized by the length from its first point.
class CurveLength {
 public:
  /// @param curve  must outlive this
  explicit CurveLength(const AdaptedCurve& curve);

  double total() const { return at_point_.back(); }
  /// Length up to a point of the curve [mm].
  double atPoint(std::size_t i) const { return at_point_[i]; }
  double at(const CurvePlace& place) const;
  /// @param length_mm  modulo the length of a closed curve, clamped to that of an open one
  CurvePlace placeAt(double length_mm) const;

 private:
  const AdaptedCurve& curve_;
  std::vector<double> at_point_;  // length up to each point; if closed, the total at the end too
};

}  // namespace lamina
