// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "frame_markers.hpp"

#include <array>

#include "conversions.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::size_t kPointsPerMarker = 40000;
constexpr double kLineShare = 0.06;  // of the frames' length

/// Blue, red, green.
constexpr std::array<std::array<float, 3>, 3> kColours = {
    {{0.10F, 0.25F, 0.90F}, {0.88F, 0.12F, 0.12F}, {0.10F, 0.70F, 0.15F}}};
constexpr std::array<const char*, 3> kNamespaces = {"nozzle_x", "nozzle_y", "nozzle_z"};

class FrameLines {
 public:
  FrameLines(const FrameSettings& settings, std::string frame)
      : settings_(settings), frame_(std::move(frame)) {
    for (int axis = 0; axis < 3; ++axis) open_[static_cast<std::size_t>(axis)] = emptyMarker(axis);
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

  std::vector<Marker> finish() {
    for (int axis = 0; axis < 3; ++axis) close(axis);
    return std::move(closed_);
  }

 private:
  void addFrame(const Point3& origin, const Eigen::Matrix3d& part_from_nozzle) {
    for (int axis = 0; axis < 3; ++axis) {
      Marker& marker = open_[static_cast<std::size_t>(axis)];
      marker.points.push_back(toMessage(origin));
      marker.points.push_back(toMessage(Point3(origin + settings_.length_mm * part_from_nozzle.col(axis))));
      if (marker.points.size() >= kPointsPerMarker) close(axis);
    }
  }

  Marker emptyMarker(int axis) {
    const auto i = static_cast<std::size_t>(axis);
    Marker marker;
    marker.header.frame_id = frame_;
    marker.ns = kNamespaces[i];
    marker.id = next_id_++;
    marker.type = Marker::LINE_LIST;
    marker.pose.orientation.w = 1.0;
    marker.scale.x = toMetres(kLineShare * settings_.length_mm);
    marker.color.r = kColours[i][0];
    marker.color.g = kColours[i][1];
    marker.color.b = kColours[i][2];
    marker.color.a = 1.0F;
    return marker;
  }

  void close(int axis) {
    Marker& marker = open_[static_cast<std::size_t>(axis)];
    if (marker.points.empty()) return;
    closed_.push_back(std::move(marker));
    marker = emptyMarker(axis);
  }

  FrameSettings settings_;
  std::string frame_;
  std::int32_t next_id_ = 0;
  std::array<Marker, 3> open_;
  std::vector<Marker> closed_;
};

}  // namespace

MarkerArray frameMarkers(const Toolpath& toolpath, const FrameSettings& settings, const std::string& frame) {
  MarkerArray markers;
  markers.markers.emplace_back();
  markers.markers.back().header.frame_id = frame;
  markers.markers.back().action = Marker::DELETEALL;
  if (settings.every_mm == 0.0) return markers;
  FrameLines lines(settings, frame);
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel) lines.add(path);
  for (Marker& marker : lines.finish()) markers.markers.push_back(std::move(marker));
  return markers;
}

}  // namespace lamina
