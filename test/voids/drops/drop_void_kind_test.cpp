// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/voids/drops/drop_filling.hpp"
#include "support/drop_lattices.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::filledLayer;
using test::rectangle;
using test::reversed;

std::vector<VoidClass> kindsOf(const DropLayer& layer) {
  std::vector<VoidClass> kinds;
  for (const DropVoid& found : fillDropVoids(layer, {})) kinds.push_back(found.kind);
  return kinds;
}

TEST(DropVoidKind, OfASquareOfContoursIsItsCore) {
  const DropLayer layer = filledLayer("drops_contour", {{rectangle(0, 0, 10.6, 10.6), {}}}, 1.0);
  for (const DropVoid& found : fillDropVoids(layer, {}))
    EXPECT_EQ(found.kind == VoidClass::Core, (found.points.front().position - Point2(5.3, 5.3)).norm() < 0.5);
  EXPECT_EQ(fillDropVoids(layer, {}).size(), 5U);
}

TEST(DropVoidKind, BesideAContourDependsOnTheInfill) {
  const Regions disc = {{circle({0, 0}, 12, 90), {}}};
  for (const VoidClass kind : kindsOf(filledLayer("drops_raster", disc, 1.0)))
    EXPECT_TRUE(kind == VoidClass::RasterBorder || kind == VoidClass::Between);
  const std::vector<VoidClass> dense = kindsOf(filledLayer("drops_dense", disc, 1.0));
  EXPECT_GT(dense.size(), 3U);
  for (const VoidClass kind : dense) EXPECT_EQ(kind, VoidClass::DenseBorder);
}

TEST(DropVoidKind, BetweenContoursOfOutlineAndHoleIsAMeeting) {
  // 5.4 mm of material round the hole: contours at 0.5, 1.5 and 2.5 from either side leave 0.4 between them.
  const Regions ring = {{rectangle(0, 0, 20.8, 20.8), {reversed(rectangle(5.4, 5.4, 15.4, 15.4))}}};
  DropVoidSettings settings;
  settings.overlap = 0.3;
  std::size_t meetings = 0;
  for (const DropVoid& found : fillDropVoids(filledLayer("drops_contour", ring, 1.0), settings))
    meetings += found.kind == VoidClass::Meeting ? 1 : 0;
  EXPECT_GT(meetings, 0U);
}

TEST(DropVoidKind, InAnAcuteCornerIsACorner) {
  // A wedge of 25 degrees: its contours' tips are 4.6 apart.
  const double half = 12.5 * M_PI / 180.0;
  const Polygon wedge = {{0, 0}, {60, -60 * std::tan(half)}, {60, 60 * std::tan(half)}};
  std::size_t corners = 0;
  for (const DropVoid& found : fillDropVoids(filledLayer("drops_contour", {{wedge, {}}}, 1.0), {})) {
    if (found.kind != VoidClass::Corner) continue;
    ++corners;
    EXPECT_LT(std::abs(found.points.front().position.y()), 60 * std::tan(half));
  }
  EXPECT_GT(corners, 2U);
}

}  // namespace
}  // namespace lamina
