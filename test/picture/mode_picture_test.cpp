// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/mode_picture.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/png_image.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// Walls round a box of 20 mm, in layers of 1 mm.
Toolpath wallsRoundBox() {
  Toolpath toolpath;
  for (int layer = 1; layer <= 20; ++layer) {
    const double z = layer;
    Path path;
    path.role = PathRole::OuterWall;
    path.is_closed = true;
    path.points = {{-10.0, -10.0, z}, {10.0, -10.0, z}, {10.0, 10.0, z}, {-10.0, 10.0, z}};
    path.bead = Bead{0.8, 1.0};
    toolpath.layers.push_back({z, 1.0, {path}});
  }
  return toolpath;
}

/// Pixels of a panel's pictures, without title and legend, that are wanted.
template <class Wanted>
int countIn(const test::PngImage& image, int panel, const Wanted& is_wanted) {
  int count = 0;
  for (int row = 150; row < 740; ++row)
    for (int column = 400 * panel; column < 400 * (panel + 1); ++column)
      if (is_wanted(image.at(column, row))) ++count;
  return count;
}

bool isRed(const Colour& c) { return c.red > 2.0 * c.green + 0.1; }
bool isGrey(const Colour& c) { return c.blue < 0.8 && c.blue > c.red && c.blue - c.red < 0.06; }

TEST(ModePicture, ShowsWhatIsUnsupportedAndWhatIsRefused) {
  const test::ScratchFolder folder;
  const Mesh part = makePart("box");
  Mesh region = part;
  region.triangles.resize(4);
  const Toolpath toolpath = wallsRoundBox();
  const Toolpath none;
  const Mesh nothing;
  drawModes({"box",
             "",
             part,
             {{"planar", "", "", {"two sides"}, toolpath, region},
              {"volumetric", "what auto takes", "", {"none"}, toolpath, nothing},
              {"adapted", "", "it has no walls", {}, none, nothing}}},
            folder.file("modes.png"));
  const test::PngImage image(folder.file("modes.png"));
  EXPECT_EQ(image.width(), 1200);
  EXPECT_GT(countIn(image, 0, isRed), 2000);
  EXPECT_EQ(countIn(image, 1, isRed), 0);
  const int grey = countIn(image, 2, isGrey);
  EXPECT_GT(grey, 20000);
  EXPECT_LT(countIn(image, 1, isGrey), grey / 2) << "bands of layers";
}

TEST(ModePicture, NothingOrTooMuchToDrawIsRefused) {
  const test::ScratchFolder folder;
  const Mesh part = makePart("box");
  const Toolpath none;
  const Mesh nothing;
  const ModePanel panel{"planar", "", "", {}, none, nothing};
  EXPECT_THROW(drawModes({"", "", part, {}}, folder.file("modes.png")), InvalidInput);
  EXPECT_THROW(drawModes({"", "", nothing, {panel}}, folder.file("modes.png")), InvalidInput);
  EXPECT_THROW(drawModes({"", "", part, std::vector<ModePanel>(13, panel)}, folder.file("modes.png")),
               InvalidInput);
  EXPECT_EQ(folder.fileCount(), 0U);
}

}  // namespace
}  // namespace lamina
