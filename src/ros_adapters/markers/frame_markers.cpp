// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/frame_markers.hpp"

#include <array>

#include "conversions.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::size_t kPointsPerFrameMarker = 40000;
constexpr double kFrameLineShare = 0.06;  // of the frames' length

/// Blue, red, green.
constexpr std::array<std::array<float, 3>, 3> kColours = {
    {{0.10F, 0.25F, 0.90F}, {0.88F, 0.12F, 0.12F}, {0.10F, 0.70F, 0.15F}}};
constexpr std::array<const char*, 3> kNamespaces = {"nozzle_x", "nozzle_y", "nozzle_z"};

class FrameLines {
 public:
  FrameLines(const FrameSettings& settings, std::string frame)
      : settings_(settings), frame_(std::move(frame)) {
    for (std::size_t axis = 0; axis < 3; ++axis) open_[axis].marker = emptyMarker(axis);
  }

  void add(const Path& path) {
    double way = settings_.every_mm;
    for (std::size_t w = 0; w < path.points.size(); ++w) {
      if (w > 0) way += (path.points[w] - path.points[w - 1]).norm();
      if (way < settings_.every_mm) continue;
      way = 0.0;
      addFrame(path.points[w], path.orientation.at(w).toRotationMatrix());
    }
  }

  void endLayer() {
    ++layers_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      MarkerChunk& chunk = open_[axis];
      chunk.points_up_to.push_back(static_cast<std::uint32_t>(chunk.marker.points.size()));
      if (chunk.marker.points.size() >= kPointsPerFrameMarker) close(axis);
    }
  }

  std::vector<MarkerChunk> finish() {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!open_[axis].marker.points.empty()) close(axis);
    return std::move(closed_);
  }

 private:
  void addFrame(const Point3& origin, const Eigen::Matrix3d& part_from_nozzle) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Point3 direction = part_from_nozzle.col(static_cast<Eigen::Index>(axis));
      open_[axis].marker.points.push_back(toMessage(origin));
      open_[axis].marker.points.push_back(toMessage(Point3(origin + settings_.length_mm * direction)));
    }
  }

  Marker emptyMarker(std::size_t axis) {
    Marker marker;
    marker.header.frame_id = frame_;
    marker.ns = kNamespaces[axis];
    marker.id = next_id_++;
    marker.type = Marker::LINE_LIST;
    marker.pose.orientation.w = 1.0;
    marker.frame_locked = 1;  // it goes where the part is put next, and with a table that moves
    marker.scale.x = toMetres(kFrameLineShare * settings_.length_mm);
    marker.color.r = kColours[axis][0];
    marker.color.g = kColours[axis][1];
    marker.color.b = kColours[axis][2];
    marker.color.a = 1.0F;
    return marker;
  }

  void close(std::size_t axis) {
    closed_.push_back(std::move(open_[axis]));
    open_[axis] = {emptyMarker(axis), layers_, {}};
  }

  FrameSettings settings_;
  std::string frame_;
  std::int32_t next_id_ = 0;
  std::size_t layers_ = 0;
  std::array<MarkerChunk, 3> open_;
  std::vector<MarkerChunk> closed_;
};

}  // namespace

std::vector<MarkerChunk> frameMarkerChunks(const Toolpath& toolpath, const FrameSettings& settings,
                                           const std::string& frame) {
  if (settings.every_mm == 0.0) return {};
  FrameLines lines(settings, frame);
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel) lines.add(path);
    lines.endLayer();
  }
  return lines.finish();
}

MarkerArray frameMarkers(const Toolpath& toolpath, const FrameSettings& settings, const std::string& frame) {
  MarkerArray markers;
  markers.markers.emplace_back();
  markers.markers.back().header.frame_id = frame;
  markers.markers.back().action = Marker::DELETEALL;
  for (MarkerChunk& chunk : frameMarkerChunks(toolpath, settings, frame))
    markers.markers.push_back(std::move(chunk.marker));
  return markers;
}

}  // namespace lamina
