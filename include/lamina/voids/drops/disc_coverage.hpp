// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Area inside an outline that drops, taken as discs, leave uncovered: the counterpart in software of
/// measuring voids under the microscope [Sobreviela2014, section 5.3].
struct DiscCoverage {
  std::size_t voids = 0;       ///< number of connected uncovered areas, pores between touching drops included
  double uncovered_mm2 = 0.0;  ///< area of all of them
  double largest_mm2 = 0.0;    ///< area of the largest
};

/// Measures the coverage on pixels of a 53rd of the diameter, or larger ones if there would be more than 100
/// million. Discs are drawn larger by a thousandth, so that touching drops enclose a void; pixels are
/// connected by their sides. All values are 0 without borders.
/// @param drops    centres, of drops of one diameter [mm]
/// @param borders  outlines of the area that is measured, even-odd
DiscCoverage discCoverage(const std::vector<Point2>& drops, double diameter_mm,
                          const std::vector<Polygon>& borders);

}  // namespace lamina
