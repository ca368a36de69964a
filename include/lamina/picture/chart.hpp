// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/picture/colour.hpp"

namespace lamina {

/// Points of a diagram that are drawn alike.
struct ChartSeries {
  std::string label;  ///< in the legend; empty for none
  std::vector<Point2> points;
  Colour colour;
  double dot_px = 0.0;   ///< radius of a dot at each point; 0 for none
  double line_px = 0.0;  ///< width of a line through the points; 0 for none
};

/// A diagram of two axes with linear scales. Later series lie over earlier ones.
struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<ChartSeries> series;
};

/// The diagram as the bytes of a PNG file. Points with a coordinate that is not finite are left out, and
/// lines pass over them. The axes reach a little beyond all points, also if these coincide.
/// @throws InvalidInput if a side is not within 200 and 16384 pixels
std::string chartPng(const Chart& chart, int width_px, int height_px);

/// Round values (1, 2 or 5 times a power of ten apart) within an interval, at most `most` + 1. If fewer than
/// two lie within, the ends of the interval instead.
/// @param low, high  finite, low less than high
std::vector<double> roundTicks(double low, double high, int most);

}  // namespace lamina
