// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/scene_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/png_image.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr Colour kFrontColour{0.9, 0.1, 0.1};
constexpr Colour kBackColour{0.1, 0.1, 0.9};

Mesh boxAt(const Point3& place) {
  Mesh mesh = makePart("box", {{"x_mm", "20"}, {"y_mm", "20"}, {"z_mm", "20"}});
  for (Point3& vertex : mesh.vertices) vertex += place;
  return mesh;
}

template <class Wanted>
int pixelsThatAre(const test::PngImage& image, const Wanted& isWanted) {
  int count = 0;
  for (int row = 0; row < image.height(); ++row)
    for (int column = 0; column < image.width(); ++column)
      if (isWanted(image.at(column, row))) ++count;
  return count;
}

bool isOfFront(const Colour& c) { return c.red > 2.0 * c.blue + 0.1; }
bool isOfBack(const Colour& c) { return c.blue > 2.0 * c.red + 0.1; }

/// A red box in front of a blue one, seen from -y or from +y, level.
ScenePicture twoBoxes(double heading) {
  ScenePicture picture{"boxes", "one behind the other", {}, {}};
  picture.solids = {{boxAt({0, -40, 0}), kFrontColour}, {boxAt({0, 40, 0}), kBackColour}};
  picture.panels = {{"seen", heading, 0.0, {0, 0, 10}, 100.0}};
  return picture;
}

TEST(ScenePicture, WhatIsInFrontHidesWhatIsBehind) {
  const test::ScratchFolder folder;
  drawScene(twoBoxes(-0.5 * M_PI), folder.file("front.png"));
  drawScene(twoBoxes(0.5 * M_PI), folder.file("back.png"));
  const test::PngImage front(folder.file("front.png"));
  const test::PngImage back(folder.file("back.png"));
  // A fifth of the panel's 620 px in both directions.
  EXPECT_NEAR(pixelsThatAre(front, isOfFront), 124 * 124, 600);
  EXPECT_EQ(pixelsThatAre(front, isOfBack), 0);
  EXPECT_NEAR(pixelsThatAre(back, isOfBack), 124 * 124, 600);
  EXPECT_EQ(pixelsThatAre(back, isOfFront), 0);
}

TEST(ScenePicture, EachPanelHasAScaleOfItsOwn) {
  const test::ScratchFolder folder;
  ScenePicture picture = twoBoxes(-0.5 * M_PI);
  drawScene(picture, folder.file("one.png"));
  picture.panels.push_back(picture.panels[0]);
  picture.panels[1].span_mm = 50.0;
  drawScene(picture, folder.file("two.png"));
  const int one = pixelsThatAre(test::PngImage(folder.file("one.png")), isOfFront);
  const int two = pixelsThatAre(test::PngImage(folder.file("two.png")), isOfFront);
  EXPECT_NEAR(two, 5 * one, 0.05 * one);
}

TEST(ScenePicture, GlassTintsWhatItHides) {
  const test::ScratchFolder folder;
  ScenePicture picture = twoBoxes(-0.5 * M_PI);
  picture.solids[0].may_be_glass = true;
  drawScene(picture, folder.file("solid.png"));
  picture.panels[0].is_of_glass = true;
  drawScene(picture, folder.file("glass.png"));
  EXPECT_EQ(pixelsThatAre(test::PngImage(folder.file("solid.png")), isOfBack), 0);
  const test::PngImage glass(folder.file("glass.png"));
  EXPECT_NEAR(pixelsThatAre(glass, isOfBack), 124 * 124, 600);
  EXPECT_EQ(pixelsThatAre(glass, isOfFront), 0);
  // Seen from the other side, what is before the glass has its own colour.
  picture.panels[0].heading_rad = 0.5 * M_PI;
  drawScene(picture, folder.file("behind.png"));
  const Colour before = test::PngImage(folder.file("behind.png")).at(322, 414);
  const Colour behind = glass.at(322, 414);
  EXPECT_GT(behind.red, before.red + 0.1);
}

TEST(ScenePicture, TheScaleBarStandsOutFromADarkGround) {
  const test::ScratchFolder folder;
  ScenePicture picture = twoBoxes(-0.5 * M_PI);
  picture.solids = {{boxAt({0, 0, 0}), Colour{0.15, 0.16, 0.18}}};
  picture.panels[0].span_mm = 15.0;  // nothing but the box
  drawScene(picture, folder.file("dark.png"));
  const test::PngImage image(folder.file("dark.png"));
  // The bar of 2 mm, 83 px, begins at (24, 708): white around it, dark itself, and dark beyond.
  EXPECT_LT(image.at(30, 708).red, 0.3);
  EXPECT_GT(image.at(30, 703).red, 0.9);
  EXPECT_GT(image.at(30, 713).red, 0.9);
  EXPECT_LT(image.at(400, 708).red, 0.3);
}

TEST(ScenePicture, PicturesOfNothingAreRefused) {
  const test::ScratchFolder folder;
  ScenePicture picture = twoBoxes(0.0);
  picture.panels[0].span_mm = 0.0;
  EXPECT_THROW(drawScene(picture, folder.file("a.png")), InvalidInput);
  picture.panels.clear();
  EXPECT_THROW(drawScene(picture, folder.file("a.png")), InvalidInput);
  EXPECT_EQ(folder.fileCount(), 0U);
}

}  // namespace
}  // namespace lamina
