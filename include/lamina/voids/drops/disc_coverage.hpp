// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// What drops, as discs, leave uncovered inside an outline: the software's counterpart of measuring voids
/// under the microscope [Sobreviela2014, section 5.3].
struct DiscCoverage {
  std::size_t voids = 0;  ///< uncovered areas that do not hang together, pores between touching drops too
  double uncovered_mm2 = 0.0;
  double largest_mm2 = 0.0;  ///< of these areas
};

/// Measured on pixels of a 53rd of the diameter, larger where there would be more than 100 million. Discs are
/// drawn larger by a thousandth, so that drops that touch bound a void; pixels hang together by their sides.
/// @param drops    centres, of one diameter
/// @param borders  of the area looked at, even-odd
DiscCoverage discCoverage(const std::vector<Point2>& drops, double diameter_mm,
                          const std::vector<Polygon>& borders);

}  // namespace lamina
