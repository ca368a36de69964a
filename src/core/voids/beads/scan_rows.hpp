// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Evenly spaced lines along x. Row i is at low + (i + 1/2) spacing and represents the strip around it.
struct ScanRows {
  double low_mm = 0.0;
  double spacing_mm = 1.0;
  std::size_t count = 0;

  double at(std::size_t row) const { return low_mm + (static_cast<double>(row) + 0.5) * spacing_mm; }
  /// Index of the first row at or above y, at most `count`.
  std::size_t firstAbove(double y) const;
};

/// A piece of a row, x from low to high [mm].
struct Span {
  double low = 0.0;
  double high = 0.0;
  double length() const { return high - low; }
};

/// Disjoint intervals of one row, ascending.
using Spans = std::vector<Span>;

/// The intervals inside the outlines by the even-odd rule, row by row.
std::vector<Spans> insideSpans(const std::vector<Polygon>& outlines, const ScanRows& rows);

/// The intervals sorted, and merged where they touch or overlap.
Spans united(Spans spans);

/// The parts of `spans` that are outside `subtracted`.
Spans difference(const Spans& spans, const Spans& subtracted);

}  // namespace lamina
