// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A stretch of a raster line that is to be deposited [mm, raster frame].
struct RasterRow {
  std::int64_t line = 0;  ///< by number, from below
  double left_mm = 0.0;
  double right_mm = 0.0;
};

/// How far apart the lines are, and what still counts as side by side [mm].
struct RowSpacing {
  double between_lines_mm = 0.4;
  double reach_mm = 0.0;  ///< between the ends of two rows of neighbouring lines, along them
};

/// A row in the order deposited.
struct RowVisit {
  std::size_t row = 0;
  bool enters_right = false;
};

/// An order of the rows in one sense across them: each comes after all the rows of the line below that it
/// lies beside, so that none is deposited between two earlier ones. Rows that lie one above the other and
/// beside no others are chains, deposited to and fro; after each goes the nearest of those whose rows below
/// are all deposited. Time: linear in the rows for as many on each line, quadratic in those and the chains.
///
/// @param rows  line by line from below
/// @param from  where the nozzle comes from [mm, raster frame]
/// @return every row once
std::vector<RowVisit> orderInOneSense(const std::vector<RasterRow>& rows, const RowSpacing& spacing,
                                      const Point2& from);

}  // namespace lamina
