// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/arrangement.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/convex_hull.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

const Box2 kBed{{0, 0}, {220, 220}};

PlateSettings settingsFor(PlateArrangement arrangement) {
  PlateSettings settings;
  settings.arrangement = arrangement;
  return settings;
}

Polygon centred(Polygon hull) {
  const Point2 middle = boundingBox({hull}).centre();
  for (Point2& corner : hull) corner -= middle;
  return hull;
}

Footprint rectangleOf(double width_mm, double depth_mm) {
  return {"part", test::rectangle(-0.5 * width_mm, -0.5 * depth_mm, 0.5 * width_mm, 0.5 * depth_mm), {}};
}

/// A footprint as it stands.
Regions standingAt(const Footprint& footprint, const PlatePlace& place) {
  Polygon turned;
  const Eigen::Rotation2D<double> turn(place.eighths * M_PI / 4.0);
  for (const Point2& corner : footprint.hull) turned.push_back(turn * corner);
  turned = centred(turned);
  for (Point2& corner : turned) corner += place.at_mm;
  return {Region{turned, {}}};
}

std::vector<Footprint> randomFootprints(std::uint64_t seed) {
  Random random(seed);
  std::vector<Footprint> footprints;
  const int count = 2 + static_cast<int>(random.uniform(0.0, 10.0));
  for (int i = 0; i < count; ++i) {
    const Polygon hull = convexHull(test::star(random, {0, 0}, 3.0, 25.0, 3 + i));
    footprints.push_back({"part", centred(hull), {}});
  }
  return footprints;
}

TEST(Arrangement, LaysRowsInTheOrderGiven) {
  const std::vector<Footprint> footprints(3, rectangleOf(100, 40));
  const auto places = arranged(footprints, kBed, settingsFor(PlateArrangement::Rows));
  // Two in the first row, one behind; 205 x 85 mm in the middle of the bed.
  EXPECT_LT((places[0].at_mm - Point2(57.5, 87.5)).norm(), 1e-9);
  EXPECT_LT((places[1].at_mm - Point2(162.5, 87.5)).norm(), 1e-9);
  EXPECT_LT((places[2].at_mm - Point2(57.5, 132.5)).norm(), 1e-9);
}

TEST(Arrangement, PlacesAPartAloneWhoseBrimReachesBeyondTheBed) {
  const Point2 size = kBed.size();
  Footprint alone = rectangleOf(size.x() - 8.0, size.y() - 8.0);
  alone.beside_mm = 6.0;
  for (const PlateArrangement arrangement : {PlateArrangement::Rows, PlateArrangement::Pack})
    EXPECT_LT((arranged({alone}, kBed, settingsFor(arrangement)).front().at_mm - kBed.centre()).norm(), 1e-9);
}

TEST(Arrangement, LeavesPartsThatHaveAPlace) {
  for (const PlateArrangement arrangement : {PlateArrangement::Rows, PlateArrangement::Pack}) {
    std::vector<Footprint> footprints(3, rectangleOf(60, 40));
    footprints[1].at_mm = Point2(30, 20);
    const auto places = arranged(footprints, kBed, settingsFor(arrangement));
    EXPECT_EQ(places[1].at_mm, Point2(30, 20));
    for (const std::size_t i : {0U, 2U})
      EXPECT_TRUE(intersection(offset(standingAt(footprints[i], places[i]), 4.99),
                               standingAt(footprints[1], places[1]))
                      .empty());
  }
}

TEST(Arrangement, PacksCloserThanRows) {
  // Triangles of half a box each: turned by half a turn, two of them fill one.
  const Polygon triangle = centred({{0, 0}, {60, 0}, {0, 60}});
  const std::vector<Footprint> footprints(12, Footprint{"triangle", triangle, {}});
  EXPECT_THROW(arranged(footprints, kBed, settingsFor(PlateArrangement::Rows)), Unreachable);
  EXPECT_EQ(arranged(footprints, kBed, settingsFor(PlateArrangement::Pack)).size(), 12U);
}

TEST(Arrangement, KeepsPartsApartAndOnTheBed) {
  EXPECT_TRUE(rc::check("arranged parts are apart by the spacing, within the bed", [](std::uint64_t seed) {
    const std::vector<Footprint> footprints = randomFootprints(seed);
    const bool packs = seed % 2 == 0;
    PlateSettings settings = settingsFor(packs ? PlateArrangement::Pack : PlateArrangement::Rows);
    std::vector<PlatePlace> places;
    try {
      places = arranged(footprints, kBed, settings);
    } catch (const Unreachable&) {
      RC_DISCARD("no room");
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Regions here = standingAt(footprints[i], places[i]);
      const Box2 box = boundingBox(outlines(here));
      RC_ASSERT((box.low.array() >= kBed.low.array() - 1e-6).all());
      RC_ASSERT((box.high.array() <= kBed.high.array() + 1e-6).all());
      for (std::size_t k = 0; k < i; ++k)
        RC_ASSERT(area(intersection(offset(here, settings.spacing_mm - 0.01, Join::Round),
                                    standingAt(footprints[k], places[k]))) < 1e-6);
    }
  }));
}

}  // namespace
}  // namespace lamina
