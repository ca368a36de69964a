// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/collision_markers.hpp"

#include "conversions.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kShaft = 0.6;       // mm
constexpr double kPoint = 1.5;       // mm
constexpr double kText = 4.0;        // mm: height of a letter
constexpr double kTextAbove = 10.0;  // mm, over the tip

Marker markerAt(const std::string& name, int id, std::int32_t type) {
  Marker marker;
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = 1;  // it goes where the part is put next, and with a table that moves
  marker.color.r = 0.85F;
  marker.color.a = 1.0F;
  return marker;
}

Marker arrowOf(const Collision& collision, int id) {
  Marker arrow = markerAt("collision", id, Marker::ARROW);
  arrow.points = {toMessage(collision.tip), toMessage(collision.place)};
  arrow.scale.x = toMetres(kShaft);
  arrow.scale.y = toMetres(kPoint);
  return arrow;
}

Marker collisionTextOf(const Collision& collision) {
  Marker text = markerAt("first_collision", 0, Marker::TEXT_VIEW_FACING);
  text.pose.position = toMessage(Point3(collision.tip + kTextAbove * Point3::UnitZ()));
  text.scale.z = toMetres(kText);
  text.text = toText(collision.at) + ": " + collision.link + " in " + toString(collision.obstacle);
  return text;
}

}  // namespace

MarkerArray collisionMarkers(const ClearanceReport& report, const std::string& frame) {
  MarkerArray all;
  all.markers.emplace_back();
  all.markers.back().action = Marker::DELETEALL;
  int id = 0;
  for (const Collision& collision : report.first_of_layers) all.markers.push_back(arrowOf(collision, id++));
  if (!report.first_of_layers.empty()) all.markers.push_back(collisionTextOf(report.first_of_layers.front()));
  for (Marker& marker : all.markers) marker.header.frame_id = frame;
  return all;
}

}  // namespace lamina
