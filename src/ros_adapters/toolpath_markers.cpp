// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "toolpath_markers.hpp"

#include <array>

#include "conversions.hpp"
#include "lamina/picture/toolpath_picture.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::size_t kRoles = 6;
constexpr std::size_t kPointsPerMarker = 40000;
constexpr double kTravelWidth = 0.05;  // mm: a hair beside any bead
constexpr double kLineShare = 0.25;    // of the bead: what is deposited and measured shows between the lines
constexpr float kTravelOpacity = 0.15F;

std_msgs::ColorRGBA colour(PathRole role) {
  const Colour drawn = roleColour(role);
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(drawn.red);
  message.g = static_cast<float>(drawn.green);
  message.b = static_cast<float>(drawn.blue);
  message.a = role == PathRole::Travel ? kTravelOpacity : static_cast<float>(drawn.alpha);
  return message;
}

/// Collects the segments, and drops, of each role and gives them away as markers at the ends of layers.
class MarkerChunks {
 public:
  explicit MarkerChunks(const std::string& frame) : frame_(frame) {
    Marker clear;
    clear.header.frame_id = frame;
    clear.action = Marker::DELETEALL;
    markers_.markers.push_back(clear);
    for (std::size_t role = 0; role < kRoles; ++role) {
      open_[role] = emptyMarker(static_cast<PathRole>(role), Marker::LINE_LIST);
      open_[kRoles + role] = emptyMarker(static_cast<PathRole>(role), Marker::SPHERE_LIST);
    }
  }

  void add(const Path& path) {
    if (path.deposit == Deposit::Drops) return addDrops(path);
    Marker& marker = open_[static_cast<std::size_t>(path.role)];
    const bool is_travel = path.role == PathRole::Travel;
    marker.scale.x = toMetres(is_travel ? kTravelWidth : kLineShare * path.bead.at(0).width_mm);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      marker.points.push_back(toMessage(path.points[m]));
      marker.points.push_back(toMessage(path.points[path.motionEnd(m)]));
    }
  }

  void endLayer() {
    for (Marker& marker : open_)
      if (marker.points.size() >= kPointsPerMarker) close(marker);
  }

  MarkerArray finish() {
    for (Marker& marker : open_)
      if (!marker.points.empty()) close(marker);
    return std::move(markers_);
  }

 private:
  void addDrops(const Path& path) {
    Marker& marker = open_[kRoles + static_cast<std::size_t>(path.role)];
    marker.scale.x = marker.scale.y = toMetres(path.bead.at(0).width_mm);
    marker.scale.z = toMetres(path.bead.at(0).height_mm);
    for (const Point3& drop : path.points) marker.points.push_back(toMessage(drop));
  }

  Marker emptyMarker(PathRole role, std::int32_t type) {
    Marker marker;
    marker.header.frame_id = frame_;
    marker.ns = toString(role);
    marker.id = next_id_++;
    marker.type = type;
    marker.pose.orientation.w = 1.0;
    marker.color = colour(role);
    return marker;
  }

  void close(Marker& marker) {
    Marker next = emptyMarker(pathRoleFromString(marker.ns), marker.type);
    markers_.markers.push_back(std::move(marker));
    marker = std::move(next);
  }

  std::string frame_;
  int next_id_ = 0;
  std::array<Marker, 2 * kRoles> open_;  ///< of beads, then of drops
  MarkerArray markers_;
};

}  // namespace

MarkerArray toolpathMarkers(const Toolpath& toolpath, const std::string& frame) {
  MarkerChunks chunks(frame);
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths) chunks.add(path);
    chunks.endLayer();
  }
  return chunks.finish();
}

}  // namespace lamina
