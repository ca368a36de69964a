// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/picture/canvas.hpp"

namespace lamina {

/// Title in the top left corner and a smaller line below it; together 70 px high, and 22 px more for each
/// further line of the subtitle.
void drawTitle(Canvas& canvas, const std::string& title, const std::string& subtitle);

/// A bar of a round length (1, 2 or 5 times a power of ten mm), at most 200 px long, labelled with it.
/// @param at  its left end [px]
void drawScaleBar(Canvas& canvas, const Point2& at);

struct LegendEntry {
  std::string label;
  Colour colour;
};

/// A row of coloured squares, each with its label.
/// @param at  left end of the base line [px]
void drawLegend(Canvas& canvas, const Point2& at, const std::vector<LegendEntry>& entries);

/// The values a colour map stands for.
struct ColourScale {
  ColourMap map = ColourMap::Sequential;
  double low = 0.0;
  double high = 1.0;
  std::string label;  ///< what it is and its unit: "height [mm]"
};

/// A vertical bar of the map's colours with its label above and five values beside it.
/// @param bar  [px]; the values need some 70 px to its right
void drawColourBar(Canvas& canvas, const Box2& bar, const ColourScale& scale);

}  // namespace lamina
