// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Overlap that new drops bring into a layer or part. [Sobreviela2014, section 5.1] names no denominator
/// of its "total overlap": both readings are given.
struct OverlapReading {
  double greatest_linear = 0.0;  ///< of a pair with a new drop
  double greatest_area = 0.0;    ///< of a pair with a new drop
  double sum_area = 0.0;         ///< of all pairs of a new drop and a prior one, in discs
  std::size_t prior = 0;
  std::size_t added = 0;

  /// Of a new drop with prior ones, on average, in discs; 0 without new drops.
  double perNewDrop() const;
  /// The same for all drops: the final overlap in the part.
  double perDrop() const;
};

/// Readings of two layers as those of both.
OverlapReading operator+(const OverlapReading& a, const OverlapReading& b);

OverlapReading measureOverlap(const std::vector<Point2>& prior, const std::vector<Point2>& added,
                              double diameter_mm);

}  // namespace lamina
