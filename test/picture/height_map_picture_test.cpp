// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/height_map_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
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

bool isPng(const std::string& path) { return readFile(path).rfind("\x89PNG\r\n", 0) == 0; }

TEST(HeightMapPicture, DrawsMapsFinerAndCoarserThanPixels) {
  const test::ScratchFolder folder;
  for (const double cell : {0.02, 0.1, 5.0}) {
    drawHeightMap(folder.file("a.png"), dome(cell), {"Dome", "a test"});
    EXPECT_TRUE(isPng(folder.file("a.png")));
  }
}

TEST(HeightMapPicture, DrawsDeviationsAndMapsOfNothing) {
  const test::ScratchFolder folder;
  drawDeviation(folder.file("a.png"), dome(0.5), {"Dome", ""});
  EXPECT_TRUE(isPng(folder.file("a.png")));
  drawDeviation(folder.file("b.png"), HeightMap(heightGrid({Point2(0, 0), Point2(1, 1)}, 0.5)), {"", ""});
  EXPECT_TRUE(isPng(folder.file("b.png")));
}

TEST(HeightMapPicture, AFolderThatIsMissingIsAnError) {
  EXPECT_THROW(drawHeightMap("/nonexistent/a.png", dome(1.0), {"", ""}), FileError);
}

}  // namespace
}  // namespace lamina
