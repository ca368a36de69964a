// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Places of a layer against boxes that are united one by one.
#include "planning/cooling/place_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

ToolpathLayer runsAnywhere(Random& random, std::size_t count) {
  ToolpathLayer layer{0.2, 0.2, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 at(random.uniform(0, 60), random.uniform(0, 60), 0.2);
    Path path;
    path.role = PathRole::OuterWall;
    path.points = {at, at + Point3(random.uniform(0, 8), random.uniform(0, 8), 0)};
    path.bead = Bead{0.4, 0.2};
    layer.paths.push_back(path);
  }
  return layer;
}

bool meet(const Box2& a, const Box2& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

std::vector<Box2> unitedOneByOne(const ToolpathLayer& layer) {
  std::vector<Box2> boxes;
  for (const Path& path : layer.paths) {
    Box2 grown;
    for (const Point3& point : path.points) grown.include(point.head<2>());
    grown.low.array() -= 0.2;
    grown.high.array() += 0.2;
    for (auto other = boxes.begin(); other != boxes.end();) {
      if (!meet(*other, grown)) {
        ++other;
        continue;
      }
      grown.include(other->low);
      grown.include(other->high);
      boxes.erase(other);
      other = boxes.begin();
    }
    boxes.push_back(grown);
  }
  return boxes;
}

TEST(PlaceOrder, UnitesWhatOverlaps) {
  ASSERT_TRUE(rc::check("random runs", [] {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000)));
    const ToolpathLayer layer = runsAnywhere(random, static_cast<std::size_t>(*rc::gen::inRange(0, 120)));
    std::vector<Box2> expected = unitedOneByOne(layer);
    const PlacedLayer placed = placesOf(layer, Eigen::Quaterniond::Identity());
    RC_ASSERT(placed.places.size() == expected.size());
    std::size_t visits = 0;
    for (const DepositedPlace& place : placed.places) {
      RC_ASSERT(std::count_if(expected.begin(), expected.end(), [&](const Box2& box) {
                  return (box.low - place.box.low).norm() + (box.high - place.box.high).norm() < 1e-9;
                }) == 1);
      for (const std::size_t visit : place.visits)
        for (std::size_t p = placed.visits[visit].begin; p < placed.visits[visit].end; ++p)
          RC_ASSERT((layer.paths[p].points[0].head<2>().array() > place.box.low.array()).all());
      visits += place.visits.size();
    }
    RC_ASSERT(visits == placed.visits.size());
  }));
}

TEST(PlaceOrder, NumbersPlacesAsTheyAreFirstVisited) {
  ToolpathLayer layer{0.2, 0.2, {}};
  for (const double x : {40.0, 0.0, 20.0, 40.5}) {
    Path path;
    path.role = PathRole::OuterWall;
    path.points = {{x, 0, 0.2}, {x, 5, 0.2}};
    path.bead = Bead{0.4, 0.2};
    layer.paths.push_back(path);
  }
  layer.paths.back().points[0].x() = 40.1;
  const PlacedLayer placed = placesOf(layer, Eigen::Quaterniond::Identity());
  ASSERT_EQ(placed.places.size(), 3U);
  EXPECT_EQ(placed.places[0].visits, (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(placed.places[1].visits, (std::vector<std::size_t>{1}));
}

}  // namespace
}  // namespace lamina
