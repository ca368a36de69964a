// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/canvas.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/picture/annotation.hpp"
#include "support/png_image.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr Colour kRed{1.0, 0.0, 0.0};

Box2 box(double x0, double y0, double x1, double y1) {
  Box2 made;
  made.include({x0, y0});
  made.include({x1, y1});
  return made;
}

TEST(Canvas, ShowsAPieceOfThePlaneAtOneScale) {
  Canvas canvas(200, 100);
  canvas.show(box(0, 0, 10, 10), box(0, 0, 200, 100));
  EXPECT_DOUBLE_EQ(canvas.pixelsPerMm(), 10.0);
  EXPECT_TRUE(canvas.toPixels({0, 0}).isApprox(Point2(50, 100)));
  EXPECT_TRUE(canvas.toPixels({10, 10}).isApprox(Point2(150, 0)));
}

TEST(Canvas, ShowsAnEmptyPieceAsOneMillimetre) {
  Canvas canvas(100, 100);
  canvas.show(Box2{}, box(0, 0, 100, 100));
  EXPECT_DOUBLE_EQ(canvas.pixelsPerMm(), 100.0);
}

TEST(Canvas, DrawsLinesOfTheirWidth) {
  const test::ScratchFolder folder;
  Canvas canvas(100, 100);
  canvas.linePx({{10, 50}, {90, 50}}, {kRed, 10.0});
  canvas.writePng(folder.file("line.png"));
  const test::PngImage image(folder.file("line.png"));
  EXPECT_EQ(image.at(50, 46).green, 0.0);
  EXPECT_EQ(image.at(50, 54).green, 0.0);
  EXPECT_EQ(image.at(50, 43).green, 1.0);
  EXPECT_EQ(image.at(50, 56).green, 1.0);
}

TEST(Canvas, PutsTheFirstRowOfARasterAtTheBottom) {
  const test::ScratchFolder folder;
  Canvas canvas(100, 100);
  canvas.show(box(0, 0, 1, 2), box(0, 0, 100, 100));
  canvas.raster(box(0, 0, 1, 2), {1, 2, {kRed, {0.0, 0.0, 1.0}}});
  canvas.writePng(folder.file("raster.png"));
  const test::PngImage image(folder.file("raster.png"));
  EXPECT_EQ(image.at(50, 75).red, 1.0);
  EXPECT_EQ(image.at(50, 25).blue, 1.0);
  EXPECT_EQ(image.at(50, 25).red, 0.0);
}

TEST(Canvas, RefusesSizesAndFoldersThatCannotBe) {
  EXPECT_THROW(Canvas(0, 100), InvalidInput);
  EXPECT_THROW(Canvas(100, 100000), InvalidInput);
  EXPECT_THROW(Canvas(100, 100).writePng("/nonexistent/picture.png"), FileError);
}

/// Whether anything is drawn from one corner to the other, in pixels.
bool hasInk(const test::PngImage& image, const Box2& area) {
  const Colour paper = image.at(0, 0);
  for (int row = int(area.low.y()); row < int(area.high.y()); ++row)
    for (int column = int(area.low.x()); column < int(area.high.x()); ++column) {
      const Colour dot = image.at(column, row);
      if (dot.red != paper.red || dot.green != paper.green || dot.blue != paper.blue) return true;
    }
  return false;
}

TEST(Annotation, IsDrawnWhereItIsPut) {
  const test::ScratchFolder folder;
  Canvas canvas(600, 400);
  canvas.show(box(0, 0, 30, 20), box(40, 84, 560, 328));
  drawTitle(canvas, "title", "subtitle");
  drawScaleBar(canvas, {40, 370});
  drawLegend(canvas, {300, 374}, {{"one", kRed}});
  drawColourBar(canvas, box(480, 120, 500, 300), {ColourMap::Diverging, -1.0, 1.0, "error [mm]"});
  canvas.writePng(folder.file("annotation.png"));
  const test::PngImage image(folder.file("annotation.png"));
  EXPECT_TRUE(hasInk(image, box(0, 0, 600, 84))) << "title";
  EXPECT_TRUE(hasInk(image, box(40, 330, 290, 400))) << "scale bar";
  EXPECT_TRUE(hasInk(image, box(300, 330, 470, 400))) << "legend";
  EXPECT_TRUE(hasInk(image, box(480, 120, 500, 300))) << "colour bar";
  EXPECT_FALSE(hasInk(image, box(40, 90, 440, 320))) << "nothing is shown yet";
}

TEST(Colour, MapsEndAndMiddle) {
  EXPECT_GT(colourAt(ColourMap::Diverging, 0.0).blue, 0.5);
  EXPECT_GT(colourAt(ColourMap::Diverging, 1.0).red, 0.5);
  EXPECT_NEAR(colourAt(ColourMap::Diverging, 0.5).red, colourAt(ColourMap::Diverging, 0.5).blue, 1e-12);
  EXPECT_EQ(colourAt(ColourMap::Sequential, -5.0).red, colourAt(ColourMap::Sequential, 0.0).red);
  EXPECT_EQ(colourAt(ColourMap::Sequential, std::nan("")).red,
            colourAt(ColourMap::Diverging, std::nan("")).red);
}

}  // namespace
}  // namespace lamina
