// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Overlap that new drops cause in a layer or part. As [Sobreviela2014, section 5.1] does not define the
/// denominator of its "total overlap", there are two means.
struct OverlapReading {
  double greatest_linear = 0.0;  ///< greatest linear overlap of a pair with a new drop (`OverlapDefinition`)
  double greatest_area = 0.0;    ///< greatest overlap by area of a pair with a new drop
  double sum_area = 0.0;         ///< sum of the overlaps by area of all pairs of a new and a prior drop
  std::size_t prior = 0;         ///< number of prior drops
  std::size_t added = 0;         ///< number of new drops

  /// Mean of `sum_area` per new drop; 0 without new drops.
  double perNewDrop() const;
  /// Mean of `sum_area` per drop, prior and new; 0 without drops.
  double perDrop() const;
};

/// The readings of two layers taken together.
OverlapReading operator+(const OverlapReading& a, const OverlapReading& b);
/// Measures the overlap that new drops cause in one layer.
/// @param prior, added  centres of the prior and new drops [mm]

OverlapReading measureOverlap(const std::vector<Point2>& prior, const std::vector<Point2>& added,
                              double diameter_mm);

}  // namespace lamina
