// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Lines along x, evenly apart: row i lies at low + (i + 1/2) spacing and stands for the stripe around it.
struct ScanRows {
  double low_mm = 0.0;
  double spacing_mm = 1.0;
  std::size_t count = 0;

  double at(std::size_t row) const { return low_mm + (static_cast<double>(row) + 0.5) * spacing_mm; }
  /// The first row at or above y, at most `count`.
  std::size_t firstAbove(double y) const;
};

/// A piece of a row, x from low to high [mm].
struct Span {
  double low = 0.0;
  double high = 0.0;
  double length() const { return high - low; }
};

/// Pieces of one row, ascending and apart.
using Spans = std::vector<Span>;

/// What lies inside the outlines by the even-odd rule, row by row.
std::vector<Spans> insideSpans(const std::vector<Polygon>& outlines, const ScanRows& rows);

/// Sorted and joined where they touch.
Spans united(Spans spans);

/// What is in `spans` and not in `subtracted`.
Spans difference(const Spans& spans, const Spans& subtracted);

}  // namespace lamina
