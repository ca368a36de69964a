// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/region_picture.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/png_image.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

template <class Wanted>
int countOf(const test::PngImage& image, const Wanted& isWanted) {
  int count = 0;
  for (int row = 0; row < image.height(); ++row)
    for (int column = 0; column < image.width(); ++column)
      if (isWanted(image.at(column, row))) ++count;
  return count;
}

TEST(RegionPicture, ShowsTheRegionInRedOnTheGreyPart) {
  const test::ScratchFolder folder;
  const Mesh part = makePart("box");
  Mesh region = part;
  region.triangles.resize(4);
  drawRegion({"box", "too level", part, region}, folder.file("region.png"));
  const test::PngImage image(folder.file("region.png"));
  EXPECT_GT(countOf(image, [](const Colour& c) { return c.red > 2.0 * c.green + 0.1; }), 2000);
  EXPECT_GT(countOf(image, [](const Colour& c) { return c.blue < 0.8 && c.blue > c.red; }), 20000);
}

TEST(RegionPicture, NothingToDrawIsRefused) {
  const test::ScratchFolder folder;
  EXPECT_THROW(drawRegion({"nothing", "", {}, {}}, folder.file("region.png")), InvalidInput);
  EXPECT_EQ(folder.fileCount(), 0U);
}

}  // namespace
}  // namespace lamina
