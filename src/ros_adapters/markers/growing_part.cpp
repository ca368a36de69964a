// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/growing_part.hpp"

#include <utility>

#include "conversions.hpp"
#include "lamina/picture/toolpath_picture.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr int kGrownRoles = static_cast<int>(kPathRoles);

Marker emptyMarker(const std::string& frame, std::size_t layer, PathRole role) {
  const Colour drawn = roleColour(role);
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = "deposited";
  marker.id = static_cast<int>(layer) * kGrownRoles + static_cast<int>(role);
  marker.type = Marker::LINE_LIST;
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = 1;  // it goes with a table that moves
  marker.color.r = static_cast<float>(drawn.red);
  marker.color.g = static_cast<float>(drawn.green);
  marker.color.b = static_cast<float>(drawn.blue);
  marker.color.a = 1.0F;
  return marker;
}

/// The number of the motion that ends at a waypoint; as many as there are waypoints if there is none.
std::size_t motionTo(const Path& path, std::size_t waypoint) {
  if (waypoint > 0) return waypoint - 1;
  return path.is_closed ? path.points.size() - 1 : 0;
}

}  // namespace

GrowingPart::GrowingPart(const Toolpath& toolpath, std::string frame)
    : toolpath_(toolpath), frame_(std::move(frame)) {}

MarkerArray GrowingPart::upTo(const WaypointIndex& heading_for) {
  WaypointIndex end = heading_for;
  end.waypoint = motionTo(toolpath_.layers.at(end.layer).paths.at(end.path), end.waypoint);
  const bool goes_back = end < next_;
  MarkerArray changed;
  if (!has_begun_ || goes_back) begin(changed);
  lay(end, changed);
  return changed;
}

MarkerArray GrowingPart::whole() {
  MarkerArray all;
  begin(all);
  lay({toolpath_.layers.size(), 0, 0}, all);
  return all;
}

MarkerArray GrowingPart::soFar() const {
  GrowingPart anew(toolpath_, frame_);
  MarkerArray all;
  anew.begin(all);
  anew.lay(next_, all);
  return all;
}

void GrowingPart::begin(MarkerArray& markers) {
  next_ = {};
  layer_.markers.clear();
  has_changed_ = false;
  markers.markers.push_back(emptyMarker(frame_, 0, PathRole::Skirt));
  markers.markers.back().action = Marker::DELETEALL;
  has_begun_ = true;
}

bool GrowingPart::isBefore(const WaypointIndex& at) const {
  return next_.layer < toolpath_.layers.size() && next_ < at;
}

void GrowingPart::lay(const WaypointIndex& at, MarkerArray& markers) {
  while (isBefore(at)) {
    const std::vector<Path>& paths = toolpath_.layers[next_.layer].paths;
    if (next_.path >= paths.size()) {
      publishLayer(markers);
      layer_.markers.clear();
      next_ = {next_.layer + 1, 0, 0};
    } else if (next_.waypoint >= paths[next_.path].motionCount()) {
      ++next_.path;
      next_.waypoint = 0;
    } else {
      addMotion(next_);
      ++next_.waypoint;
    }
  }
  publishLayer(markers);
}

void GrowingPart::addMotion(const WaypointIndex& at) {
  const Path& path = toolpath_.layers[at.layer].paths[at.path];
  const Bead& bead = path.bead.at(path.motionEnd(at.waypoint));
  if (path.role == PathRole::Travel || bead.width_mm <= 0.0) return;
  if (layer_.markers.empty())
    for (int role = 0; role < kGrownRoles; ++role)
      layer_.markers.push_back(emptyMarker(frame_, at.layer, static_cast<PathRole>(role)));
  Marker& marker = layer_.markers[static_cast<std::size_t>(path.role)];
  marker.scale.x = toMetres(bead.width_mm);
  for (const std::size_t w : {at.waypoint, path.motionEnd(at.waypoint)}) {
    const Point3 tool_axis = path.orientation.at(w) * Point3::UnitZ();
    marker.points.push_back(toMessage(Point3(path.points[w] + 0.5 * bead.height_mm * tool_axis)));
  }
  has_changed_ = true;
}

void GrowingPart::publishLayer(MarkerArray& markers) {
  if (!std::exchange(has_changed_, false)) return;
  for (const Marker& marker : layer_.markers)
    if (!marker.points.empty()) markers.markers.push_back(marker);
}

}  // namespace lamina
