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
  std::int64_t line = 0;  ///< number of the line, from below
  double left_mm = 0.0;
  double right_mm = 0.0;
};

/// Distance of the lines, and the limit for neighbouring rows [mm].
struct RowSpacing {
  double between_lines_mm = 0.4;
  /// Greatest distance along the lines at which two rows of neighbouring lines still lie side by side.
  double reach_mm = 0.0;
};

/// A row, and its direction, in the order of deposition.
struct RowVisit {
  std::size_t row = 0;
  bool enters_right = false;
};

/// An order of the rows in which lines are deposited in one direction across them: each row comes after all
/// rows of the line below that lie beside it, so that none is deposited between two earlier ones. Rows that
/// lie above each other and beside no others form chains, which are deposited to and fro. The next chain is
/// the nearest one whose rows below are all deposited. Time is linear in the rows if each line has few, and
/// quadratic in the rows of a line and in the chains.
///
/// @param rows  line by line from below
/// @param from  position from which the nozzle comes [mm, raster frame]
/// @return every row once
std::vector<RowVisit> orderInOneSense(const std::vector<RasterRow>& rows, const RowSpacing& spacing,
                                      const Point2& from);

}  // namespace lamina
