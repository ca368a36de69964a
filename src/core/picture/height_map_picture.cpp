// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/height_map_picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lamina/picture/annotation.hpp"
#include "lamina/picture/canvas.hpp"

namespace lamina {
namespace {

constexpr int kHeightMapWidth = 1200;
constexpr int kHeightMapHeight = 900;
constexpr double kOutliers = 0.005;  // part of the cells that may lie beyond either end of the colour bar

/// The heights beyond which only outliers lie; {0, 0} if nothing is known.
std::pair<double, double> coloured(const HeightMap& map) {
  std::vector<double> known;
  for (const double height : map.heights())
    if (!std::isnan(height)) known.push_back(height);
  if (known.empty()) return {0.0, 0.0};
  const auto rank = [&known](double part) {
    const auto at = known.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), at, known.end());
    return *at;
  };
  const double low = rank(kOutliers);
  return {low, rank(1.0 - kOutliers)};
}

/// The map with `factor` by `factor` cells united, each the mean of those known.
HeightMap coarsened(const HeightMap& map, int factor) {
  const HeightGrid& grid = map.grid();
  HeightGrid coarse = grid;
  coarse.cell_mm = grid.cell_mm * factor;
  coarse.columns = (grid.columns + factor - 1) / factor;
  coarse.rows = (grid.rows + factor - 1) / factor;
  std::vector<double> sums(coarse.cellCount(), 0.0);
  std::vector<int> counts(coarse.cellCount(), 0);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double height = map.at(grid.cell(column, row));
      if (std::isnan(height)) continue;
      sums[coarse.cell(column / factor, row / factor)] += height;
      ++counts[coarse.cell(column / factor, row / factor)];
    }
  }
  HeightMap means(coarse);
  for (std::size_t cell = 0; cell < sums.size(); ++cell)
    if (counts[cell] > 0) means.set(cell, sums[cell] / counts[cell]);
  return means;
}

CellColours rasterOf(const HeightMap& map, const ColourScale& scale) {
  CellColours raster{map.grid().columns, map.grid().rows, {}};
  raster.cells.reserve(map.heights().size());
  for (const double height : map.heights())
    raster.cells.push_back(colourAt(scale.map, (height - scale.low) / (scale.high - scale.low)));
  return raster;
}

void draw(const std::string& path, const HeightMap& map, const PictureTitle& title,
          const ColourScale& scale) {
  Canvas canvas(kHeightMapWidth, kHeightMapHeight);
  drawTitle(canvas, title.title, title.subtitle);
  canvas.show(map.grid().area(), {Point2(30, 90), Point2(kHeightMapWidth - 180, kHeightMapHeight - 80)});
  // Cells finer than pixels would leave it to chance which of them is seen.
  const int cells_per_pixel = static_cast<int>(1.0 / (canvas.pixelsPerMm() * map.grid().cell_mm));
  const HeightMap shown = coarsened(map, std::max(1, cells_per_pixel));
  canvas.raster(shown.grid().area(), rasterOf(shown, scale));
  drawScaleBar(canvas, Point2(40, kHeightMapHeight - 30));
  drawColourBar(canvas,
                {Point2(kHeightMapWidth - 130, 140), Point2(kHeightMapWidth - 100, kHeightMapHeight - 120)},
                scale);
  canvas.writePng(path);
}

}  // namespace

void drawHeightMap(const std::string& path, const HeightMap& heights, const PictureTitle& title) {
  const auto [low, high] = coloured(heights);
  draw(path, heights, title, {ColourMap::Sequential, low, std::max(high, low + 0.01), "height [mm]"});
}

void drawDeviation(const std::string& path, const HeightMap& deviation, const PictureTitle& title) {
  const auto [low, high] = coloured(deviation);
  const double most = std::max({std::abs(low), std::abs(high), 0.01});
  draw(path, deviation, title, {ColourMap::Diverging, -most, most, "deviation [mm]"});
}

}  // namespace lamina
