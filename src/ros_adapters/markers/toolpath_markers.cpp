// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/toolpath_markers.hpp"

#include <array>

#include "conversions.hpp"
#include "lamina/picture/toolpath_picture.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::size_t kRoles = kPathRoles;
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
class MarkerChunker {
 public:
  explicit MarkerChunker(const std::string& frame) : frame_(frame) {
    for (std::size_t role = 0; role < kRoles; ++role) {
      open_[role].marker = emptyMarker(static_cast<PathRole>(role), Marker::LINE_LIST);
      open_[kRoles + role].marker = emptyMarker(static_cast<PathRole>(role), Marker::SPHERE_LIST);
    }
  }

  void add(const Path& path) {
    if (path.deposit == Deposit::Drops) return addDrops(path);
    Marker& marker = open_[static_cast<std::size_t>(path.role)].marker;
    const bool is_travel = path.role == PathRole::Travel;
    marker.scale.x = toMetres(is_travel ? kTravelWidth : kLineShare * path.bead.at(0).width_mm);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      marker.points.push_back(toMessage(path.points[m]));
      marker.points.push_back(toMessage(path.points[path.motionEnd(m)]));
    }
  }

  void endLayer() {
    ++layers_;
    for (MarkerChunk& chunk : open_) {
      chunk.points_up_to.push_back(static_cast<std::uint32_t>(chunk.marker.points.size()));
      if (chunk.marker.points.size() >= kPointsPerMarker) close(chunk);
    }
  }

  std::vector<MarkerChunk> finish() {
    for (MarkerChunk& chunk : open_)
      if (!chunk.marker.points.empty()) close(chunk);
    return std::move(closed_);
  }

 private:
  void addDrops(const Path& path) {
    Marker& marker = open_[kRoles + static_cast<std::size_t>(path.role)].marker;
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
    marker.frame_locked = 1;  // it goes where the part is put next, and with a table that moves
    marker.color = colour(role);
    return marker;
  }

  void close(MarkerChunk& chunk) {
    MarkerChunk next;
    next.marker = emptyMarker(pathRoleFromString(chunk.marker.ns), chunk.marker.type);
    next.first_layer = layers_;
    closed_.push_back(std::move(chunk));
    chunk = std::move(next);
  }

  std::string frame_;
  int next_id_ = 0;
  std::size_t layers_ = 0;
  std::array<MarkerChunk, 2 * kRoles> open_;  ///< of beads, then of drops
  std::vector<MarkerChunk> closed_;
};

}  // namespace

std::vector<MarkerChunk> toolpathMarkerChunks(const Toolpath& toolpath, const std::string& frame) {
  MarkerChunker chunker(frame);
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths) chunker.add(path);
    chunker.endLayer();
  }
  return chunker.finish();
}

MarkerArray toolpathMarkers(const Toolpath& toolpath, const std::string& frame) {
  MarkerArray markers;
  Marker clear;
  clear.header.frame_id = frame;
  clear.action = Marker::DELETEALL;
  markers.markers.push_back(clear);
  for (MarkerChunk& chunk : toolpathMarkerChunks(toolpath, frame))
    markers.markers.push_back(std::move(chunk.marker));
  return markers;
}

}  // namespace lamina
