// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "lamina/program/drops/drop_program.hpp"

namespace lamina::test {

/// Lines that lay drops of 1 mm one after the other.
inline std::string dropLines(const std::vector<Point2>& drops) {
  std::string lines;
  for (const Point2& drop : drops) {
    char line[64];
    std::snprintf(line, sizeof line, "G1 X%.5f Y%.5f\nM780 P3\n", drop.x(), drop.y());
    lines += line;
  }
  return lines;
}

/// The border of a square lattice of pitch 1, counter-clockwise from its low corner at `low`.
inline std::vector<Point2> squareRing(int side, const Point2& low) {
  std::vector<Point2> ring;
  const int last = side - 1;
  for (int i = 0; i < last; ++i) ring.emplace_back(i, 0);
  for (int i = 0; i < last; ++i) ring.emplace_back(last, i);
  for (int i = last; i > 0; --i) ring.emplace_back(i, last);
  for (int i = last; i > 0; --i) ring.emplace_back(0, i);
  for (Point2& drop : ring) drop += low;
  return ring;
}

/// What the ring encloses, row by row, without one drop.
inline std::vector<Point2> squareInside(int side, const Point2& low, const Point2& missing) {
  std::vector<Point2> drops;
  for (int y = 1; y < side - 1; ++y)
    for (int x = 1; x < side - 1; ++x)
      if (Point2(x, y) != missing) drops.push_back(low + Point2(x, y));
  return drops;
}

/// A place that no lattice has.
inline const Point2 kNoneMissing{-1, -1};

/// One layer of 9 x 9 drops of 1 mm from (10, 20), of which one inside is missing.
inline std::string squareLayer(int index, const Point2& missing) {
  const Point2 low(10, 20);
  const std::string number = std::to_string(index);
  return ";LAYER:" + number + "\nG1 Z" + std::to_string(index + 1) + " F600\n;TYPE:CONTOUR\n" +
         dropLines(squareRing(9, low)) + ";TYPE:INFILL\n" + dropLines(squareInside(9, low, missing)) +
         "M117 layer " + number + " done\n";
}

inline const std::string kDropHeader =
    ";drop_diameter=1\n;layer_height=1\n;strategy=drops_raster\n;units=mm\n"
    "M104 S230 ; a line of another machine\nG28\nG21\nG90\nG1 X0 Y0 F6000\n";

/// A program of such layers.
inline std::string squareProgram(const std::vector<Point2>& missing) {
  std::string text = kDropHeader;
  for (std::size_t i = 0; i < missing.size(); ++i) text += squareLayer(static_cast<int>(i), missing[i]);
  return text + ";end of the part\nG1 X0 Y200\nM84\n";
}

}  // namespace lamina::test
