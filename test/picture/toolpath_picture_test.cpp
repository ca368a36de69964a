// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/toolpath_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/png_image.hpp"
#include "support/random_toolpath.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

bool isNear(const Colour& a, const Colour& b) {
  constexpr double kTolerance = 0.03;
  return std::abs(a.red - b.red) < kTolerance && std::abs(a.green - b.green) < kTolerance &&
         std::abs(a.blue - b.blue) < kTolerance;
}

/// A bead 2 mm wide from (-10, 0) to (10, 0), and a travel.
Toolpath broadLine() {
  Path travel;
  travel.role = PathRole::Travel;
  travel.points = {{-10, 10, 1}, {-10, 0, 1}};
  travel.feed_mm_s = 100.0;
  Path line;
  line.role = PathRole::Infill;
  line.points = {{-10, 0, 1}, {10, 0, 1}};
  line.bead = Bead{2.0, 1.0};
  line.feed_mm_s = 10.0;
  Toolpath toolpath;
  toolpath.part_name = "line";
  toolpath.layers.push_back({1.0, 1.0, {travel, line}});
  return toolpath;
}

TEST(ToolpathPicture, DrawsALayerAtTrueWidth) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("layer.png");
  ToolpathPictureSettings settings;
  drawToolpathLayer(broadLine(), 0, settings, file);
  const test::PngImage image(file);
  ASSERT_EQ(image.width(), settings.width_px);
  ASSERT_EQ(image.height(), settings.height_px);
  // 22 mm (the line and 1 mm on each side) over the width without margins of 40 px.
  const double pixels_per_mm = (settings.width_px - 80) / 22.0;
  int coloured = 0;
  for (int row = 84; row < settings.height_px - 72; ++row)
    if (!isNear(image.at(settings.width_px / 2, row), {1.0, 1.0, 1.0})) ++coloured;
  EXPECT_NEAR(coloured, 2.0 * pixels_per_mm, 3.0);
}

/// A line of the grid every 50 mm would be drawn for hours.
TEST(ToolpathPicture, DrawsABedOfAnySize) {
  const test::ScratchFolder folder;
  Toolpath toolpath = broadLine();
  toolpath.layers[0].paths[1].points[1].x() = 1e10;
  EXPECT_NO_THROW(drawToolpath(toolpath, {}, folder.file("wide.png")));
}

std::vector<PathRole> depositingRoles() {
  std::vector<PathRole> roles;
  for (std::size_t i = 0; i < kPathRoles; ++i)
    if (static_cast<PathRole>(i) != PathRole::Travel) roles.push_back(static_cast<PathRole>(i));
  return roles;
}

TEST(ToolpathPicture, DrawsThePartInTheColoursOfItsRoles) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("part.png");
  ToolpathPictureSettings settings;
  settings.view = PictureView::Top;
  for (const PathRole role : depositingRoles()) {
    if (kindOf(role) == RoleKind::Wall) continue;  // lit by where their side faces
    Toolpath toolpath = broadLine();
    toolpath.layers[0].paths[1].role = role;
    drawToolpath(toolpath, settings, file);
    const test::PngImage image(file);
    const Colour middle = image.at(settings.width_px / 2, (84 + settings.height_px - 72) / 2);
    EXPECT_TRUE(isNear(middle, shaded(roleColour(role), 0.9 * 0.94)))
        << toString(role) << ": " << middle.red << " " << middle.green << " " << middle.blue;
  }
}

TEST(ToolpathPicture, NamesEveryRoleInItsLegend) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("part.png");
  const ToolpathPictureSettings settings;
  for (const PathRole role : depositingRoles()) {
    Toolpath toolpath = broadLine();
    toolpath.layers[0].paths[1].role = role;
    drawToolpath(toolpath, settings, file);
    const test::PngImage image(file);
    int legend = 0;
    for (int row = settings.height_px - 60; row < settings.height_px; ++row)
      for (int column = 0; column < settings.width_px; ++column)
        legend += isNear(image.at(column, row), roleColour(role)) ? 1 : 0;
    EXPECT_GT(legend, 50) << toString(role);
  }
}

TEST(ToolpathPicture, NamesAllRolesInSeveralRows) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("part.png");
  const ToolpathPictureSettings settings;
  Toolpath toolpath = broadLine();
  const Path line = toolpath.layers[0].paths[1];
  for (const PathRole role : depositingRoles()) {
    toolpath.layers[0].paths.push_back(line);
    toolpath.layers[0].paths.back().role = role;
  }
  drawToolpath(toolpath, settings, file);
  const test::PngImage image(file);
  for (const PathRole role : depositingRoles()) {
    int legend = 0;
    for (int row = settings.height_px - 100; row < settings.height_px; ++row)
      for (int column = 0; column < settings.width_px; ++column)
        legend += isNear(image.at(column, row), roleColour(role)) ? 1 : 0;
    EXPECT_GT(legend, 50) << toString(role);
  }
}

TEST(ToolpathPicture, GivesNoTwoRolesTheSameColour) {
  const auto roles = depositingRoles();
  for (std::size_t i = 0; i < roles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(isNear(roleColour(roles[i]), roleColour(roles[j])))
          << toString(roles[i]) << ", " << toString(roles[j]);
}

TEST(ToolpathPicture, DrawsAnyToolpath) {
  const test::ScratchFolder folder;
  ToolpathPictureSettings settings;
  settings.colour = PictureColour::Height;
  settings.width_px = 300;
  settings.height_px = 300;
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    EXPECT_NO_THROW(drawToolpath(test::randomToolpath(seed), settings, folder.file("random.png")));
}

TEST(ToolpathPicture, RefusesWhatCannotBeDrawn) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("none.png");
  EXPECT_THROW(drawToolpath(Toolpath{}, {}, file), InvalidInput);
  EXPECT_THROW(drawToolpathLayer(broadLine(), 1, {}, file), InvalidInput);
  ToolpathPictureSettings tiny;
  tiny.width_px = 3;
  EXPECT_THROW(drawToolpath(broadLine(), tiny, file), InvalidInput);
  EXPECT_THROW(drawToolpath(broadLine(), {}, "/nonexistent/picture.png"), FileError);
}

}  // namespace
}  // namespace lamina
