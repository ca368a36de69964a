// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/height_map_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "support/png_image.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

HeightMap dome(double cell_mm) {
  HeightMap map(heightGrid({Point2(-20, -15), Point2(20, 15)}, cell_mm));
  for (std::size_t cell = 0; cell < map.grid().cellCount(); ++cell) {
    const double distance = map.grid().centre(cell).norm();
    if (distance < 14.0) map.set(cell, std::sqrt(15.0 * 15.0 - distance * distance));
  }
  return map;
}

/// Pixels of a colour: neither paper nor text nor unknown cells, which are grey.
std::size_t colouredOf(const std::string& path) {
  const test::PngImage image(path);
  std::size_t coloured = 0;
  for (int row = 0; row < image.height(); ++row)
    for (int column = 0; column < image.width(); ++column) {
      const Colour dot = image.at(column, row);
      const auto [least, most] = std::minmax({dot.red, dot.green, dot.blue});
      coloured += most - least > 0.1 ? 1 : 0;
    }
  return coloured;
}

TEST(HeightMapPicture, DrawsMapsFinerAndCoarserThanPixels) {
  const test::ScratchFolder folder;
  std::vector<double> coloured;
  for (const double cell : {0.02, 0.1, 5.0}) {
    drawHeightMap(folder.file("a.png"), dome(cell), {"Dome", "a test"});
    coloured.push_back(static_cast<double>(colouredOf(folder.file("a.png"))));
  }
  EXPECT_GT(coloured[0], 1000.0);
  EXPECT_NEAR(coloured[1], coloured[0], 0.02 * coloured[0]) << "the same disc";
  // Of cells of 5 mm those with their middle within 14 mm: 24 of 25 mm2 instead of 616 mm2.
  EXPECT_NEAR(coloured[2], coloured[0], 0.05 * coloured[0]);
}

TEST(HeightMapPicture, DrawsDeviationsAndMapsOfNothing) {
  const test::ScratchFolder folder;
  drawDeviation(folder.file("a.png"), dome(0.5), {"", ""});
  HeightMap nothing = dome(0.5);
  for (std::size_t cell = 0; cell < nothing.grid().cellCount(); ++cell)
    nothing.set(cell, HeightMap::kUnknown);
  drawDeviation(folder.file("b.png"), nothing, {"", ""});
  EXPECT_GT(colouredOf(folder.file("a.png")), 2 * colouredOf(folder.file("b.png")));
}

TEST(HeightMapPicture, AFolderThatIsMissingIsAnError) {
  EXPECT_THROW(drawHeightMap("/nonexistent/a.png", dome(1.0), {"", ""}), FileError);
}

}  // namespace
}  // namespace lamina
