// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/disc_coverage.hpp"

#include <algorithm>

#include "voids/drops/disc_picture.hpp"

namespace lamina {
namespace {

constexpr double kMostPixels = 1e8;
enum Pixel : std::uint8_t { kOutside, kUncovered, kCounted };

}  // namespace

DiscCoverage discCoverage(const std::vector<Point2>& drops, double diameter_mm,
                          const std::vector<Polygon>& borders) {
  const Box2 box = boundingBox(borders);
  if (box.isEmpty()) return {};
  PixelWindow window(box, kPixel * diameter_mm, kMostPixels);
  window.paintInside(borders, kUncovered);
  for (const Point2& drop : drops) window.paintDisc(drop, kDrawnRadius * diameter_mm, kUncovered, kOutside);
  DiscCoverage coverage;
  std::size_t all = 0;
  std::size_t largest = 0;
  for (int row = 0; row < window.rows(); ++row)
    for (int column = 0; column < window.columns(); ++column) {
      if (window.at(column, row) != kUncovered) continue;
      const std::size_t size = window.flood(column, row, kCounted);
      all += size;
      largest = std::max(largest, size);
      ++coverage.voids;
    }
  coverage.uncovered_mm2 = static_cast<double>(all) * window.pixelArea();
  coverage.largest_mm2 = static_cast<double>(largest) * window.pixelArea();
  return coverage;
}

}  // namespace lamina
