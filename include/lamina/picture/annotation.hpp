// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/picture/canvas.hpp"

namespace lamina {

/// Draws a title in the top left corner, and the subtitle in smaller letters below it; together 70 px high,
/// and 22 px more for each further line of the subtitle.
void drawTitle(Canvas& canvas, const std::string& title, const std::string& subtitle);

/// Draws a bar of a round length (1, 2 or 5 times a power of ten mm), at most 200 px long, labelled with the
/// length.
/// @param at  its left end [px]
void drawScaleBar(Canvas& canvas, const Point2& at);

/// The space that the scale bar and its label take, with a margin, for a background of one colour [px].
Box2 scaleBarBox(const Canvas& canvas, const Point2& at);

struct LegendEntry {
  std::string label;
  Colour colour;
};

/// Draws a row of coloured squares, each with its label.
/// @param at  left end of the base line [px]
void drawLegend(Canvas& canvas, const Point2& at, const std::vector<LegendEntry>& entries);

/// The values that the colours of a map stand for.
struct ColourScale {
  ColourMap map = ColourMap::Sequential;
  double low = 0.0;
  double high = 1.0;
  std::string label;  ///< quantity and unit: "height [mm]"
};

/// Draws a vertical bar of the map's colours with its label above and five values beside it.
/// @param bar  [px]; the values need some 70 px to its right
void drawColourBar(Canvas& canvas, const Box2& bar, const ColourScale& scale);

}  // namespace lamina
