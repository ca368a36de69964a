// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rviz_panel/drawing/shown_layers.hpp"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <map>

namespace {

using lamina::Path;
using lamina::PathRole;
using lamina::ShownLayers;
using lamina::Toolpath;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Layers of a straight infill run each, and a wall of 2 points more in every second one; x is the layer.
Toolpath stack(int layers, int motions) {
  Toolpath toolpath;
  for (int k = 0; k < layers; ++k) {
    Path infill;
    infill.bead = lamina::Bead{0.4, 0.2};
    for (int i = 0; i <= motions; ++i) infill.points.emplace_back(k, i, 0.0);
    toolpath.layers.push_back({0.2, 0.2, {infill}});
    if (k % 2 == 1) {
      infill.role = PathRole::OuterWall;
      infill.points.resize(2);
      toolpath.layers.back().paths.push_back(infill);
    }
  }
  return toolpath;
}

ShownLayers shown(int layers, int motions) {
  ShownLayers shown;
  shown.load(lamina::toolpathMarkerChunks(stack(layers, motions), "bed"), static_cast<std::size_t>(layers));
  return shown;
}

/// What a display holds after some messages, as RViz does: by namespace and id.
class Display {
 public:
  void take(const MarkerArray& markers) {
    for (const Marker& marker : markers.markers) {
      if (marker.action == Marker::DELETEALL) held_.clear();
      if (marker.action == Marker::DELETE) held_.erase({marker.ns, marker.id});
      if (marker.action == Marker::ADD) held_[{marker.ns, marker.id}] = marker;
    }
  }
  std::size_t points() const {
    std::size_t points = 0;
    for (const auto& held : held_) points += held.second.points.size();
    return points;
  }
  double lastLayer() const {
    double last = -1.0;
    for (const auto& held : held_)
      for (const auto& point : held.second.points) last = std::max(last, 1000.0 * point.x);
    return last;
  }
  bool operator==(const Display& other) const {
    if (held_.size() != other.held_.size()) return false;
    for (const auto& [key, marker] : held_) {
      const auto found = other.held_.find(key);
      if (found == other.held_.end() || found->second.points != marker.points) return false;
    }
    return true;
  }

 private:
  std::map<std::pair<std::string, int>, Marker> held_;
};

TEST(ShownLayers, ShowExactlyTheFirstLayers) {
  ShownLayers part = shown(10, 3);
  Display display;
  display.take(part.all());
  EXPECT_EQ(display.points(), 10U * 6U + 5U * 2U);
  for (const std::size_t layers : {4U, 1U, 7U, 0U, 10U, 99U}) {
    display.take(part.show(layers));
    const std::size_t there = std::min<std::size_t>(layers, 10);
    EXPECT_EQ(display.points(), there * 6U + there / 2U * 2U);
    EXPECT_NEAR(display.lastLayer(), static_cast<double>(there) - 1.0, 1e-9);
  }
}

TEST(ShownLayers, SendAtMostAMarkerOfEachRoleForOneLayer) {
  ShownLayers part = shown(60, 5000);  // 600 000 points in 15 markers
  ASSERT_GT(part.all().markers.size(), 10U);
  std::size_t sent = 0;
  for (std::size_t layers = 59; layers > 30; --layers) {
    const MarkerArray changes = part.show(layers);
    EXPECT_LE(changes.markers.size(), 2U);
    for (const Marker& marker : changes.markers) sent = std::max(sent, marker.points.size());
  }
  EXPECT_LE(sent, 50000U);
  EXPECT_TRUE(part.show(31).markers.empty()) << "nothing changes";
}

TEST(ShownLayers, SendNewcomersWhatTheOthersSee) {
  const ShownLayers whole = shown(70, 700);  // in several markers
  EXPECT_TRUE(rc::check([&whole] {
    ShownLayers part = whole;
    Display display;
    display.take(part.all());
    for (const auto layers :
         *rc::gen::container<std::vector<std::size_t>>(5, rc::gen::inRange<std::size_t>(0, 75)))
      display.take(part.show(layers));
    Display newcomer;
    newcomer.take(part.all());
    RC_ASSERT(display == newcomer);
  }));
}

TEST(ShownLayers, MoveAsAWhole) {
  ShownLayers part = shown(3, 2);
  geometry_msgs::Point place;
  place.y = -0.5;
  part.moveTo(place);
  const MarkerArray moved = part.all();
  ASSERT_EQ(moved.markers.size(), 3U);  // of which the first deletes
  EXPECT_DOUBLE_EQ(moved.markers[1].pose.position.y, -0.5);
  EXPECT_DOUBLE_EQ(moved.markers[2].pose.position.y, -0.5);
}

TEST(ShownLayers, OfNothingDeleteWhatWasShown) {
  ShownLayers part = shown(3, 2);
  part.load({}, 0);
  ASSERT_EQ(part.all().markers.size(), 1U);
  EXPECT_EQ(part.all().markers[0].action, Marker::DELETEALL + 0);
  EXPECT_EQ(part.layerCount(), 0U);
}

}  // namespace
