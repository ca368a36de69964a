// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/height_field/followed_cells.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

/// Cells no steeper are level.
constexpr double kLevelSlope = 1e-3;

/// What the choice needs to know.
struct Place {
  double lowest = 0.0;  // height above the bed; 0 if there is none
  double slope = 0.0;   // of the layers, where they follow it
  bool has_part = false;
};

Place placeOf(const TopSurface& top, const HeightGrid& cells, std::size_t half) {
  std::array<double, 3> heights{};
  const std::array<std::size_t, 3> corners = cornersOfHalf(cells, half);
  double most = 1.0;  // height of the part over that of the surface
  for (std::size_t i = 0; i < 3; ++i) {
    if (!top.prolonged[corners[i]]) return {};
    heights[i] = *top.prolonged[corners[i]];
    if (top.over_half[half]) most = std::max(most, (*top.over_half[half])[i] / heights[i]);
  }
  return {*std::min_element(heights.begin(), heights.end()), most * slopeOfHalf(heights, cells.cell_mm),
          top.over_half[half].has_value()};
}

Place placeOfCell(const TopSurface& top, const HeightGrid& cells, std::size_t cell) {
  const Place right = placeOf(top, cells, 2 * cell);
  const Place left = placeOf(top, cells, 2 * cell + 1);
  return {std::min(right.lowest, left.lowest), std::max(right.slope, left.slope),
          right.has_part || left.has_part};
}

}  // namespace

std::vector<char> followedCells(const TopSurface& top, const HeightGrid& cells,
                                const HeightFieldSettings& settings) {
  const double steepest = std::tan(settings.max_slope_deg * M_PI / 180.0) * (1.0 + 1e-9);
  std::vector<Place> places(cells.cellCount());
  double highest = 0.0;
  for (std::size_t cell = 0; cell < places.size(); ++cell) {
    places[cell] = placeOfCell(top, cells, cell);
    if (places[cell].slope > steepest) places[cell].lowest = 0.0;
    if (places[cell].has_part) highest = std::max(highest, places[cell].lowest);
  }
  const double lowest = highest * settings.min_thickness / settings.max_thickness;
  std::vector<char> is_followed(places.size());
  for (std::size_t cell = 0; cell < places.size(); ++cell)
    is_followed[cell] = static_cast<char>(
        places[cell].lowest > 0.0 && (places[cell].lowest >= lowest || places[cell].slope < kLevelSlope));
  return is_followed;
}

}  // namespace lamina
