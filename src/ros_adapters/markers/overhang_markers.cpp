// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/overhang_markers.hpp"

#include <utility>

#include "conversions.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::size_t kPointsPerOverhangMarker = 40000;
constexpr double kStartWidths = 2.0;  // a sphere twice as wide as its bead is seen beside it

std_msgs::ColorRGBA overhangColour(float red, float green, float blue) {
  std_msgs::ColorRGBA message;
  message.r = red;
  message.g = green;
  message.b = blue;
  message.a = 1.0F;
  return message;
}

Marker overhangMarkerOf(const std::string& name, std::int32_t type,
                        const std_msgs::ColorRGBA& overhangColour) {
  Marker marker;
  marker.ns = name;
  marker.type = type;
  marker.color = overhangColour;
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = 1;  // it goes where the part is put next, and with a table that moves
  return marker;
}

/// Markers of one namespace, as many as its points need.
class MarkerSeries {
 public:
  explicit MarkerSeries(Marker first) : open_(std::move(first)) {}

  /// Room for points that belong together.
  std::vector<geometry_msgs::Point>& points(double width_m) {
    if (open_.points.size() >= kPointsPerOverhangMarker) close();
    if (open_.points.empty()) open_.scale.x = open_.scale.y = open_.scale.z = width_m;
    return open_.points;
  }

  std::vector<Marker> finish() {
    if (!open_.points.empty()) close();
    return std::move(closed_);
  }

 private:
  void close() {
    closed_.push_back(open_);
    open_.points.clear();
    ++open_.id;
  }

  Marker open_;
  std::vector<Marker> closed_;
};

void addLine(MarkerSeries& series, const UnsupportedStretch& stretch) {
  auto& points = series.points(toMetres(stretch.width_mm));
  for (std::size_t i = 1; i < stretch.points.size(); ++i) {
    points.push_back(toMessage(stretch.points[i - 1]));
    points.push_back(toMessage(stretch.points[i]));
  }
}

}  // namespace

MarkerArray overhangMarkers(const OverhangReport& report, const std::string& frame) {
  MarkerSeries overhangs(overhangMarkerOf(toString(StretchKind::Overhang), Marker::LINE_LIST,
                                          overhangColour(0.85F, 0.1F, 0.1F)));
  MarkerSeries bridges(
      overhangMarkerOf(toString(StretchKind::Bridge), Marker::LINE_LIST, overhangColour(0.95F, 0.75F, 0.1F)));
  MarkerSeries starts(
      overhangMarkerOf("start_in_air", Marker::SPHERE_LIST, overhangColour(0.8F, 0.1F, 0.8F)));
  for (const UnsupportedStretch& stretch : report.stretches) {
    addLine(stretch.kind == StretchKind::Bridge ? bridges : overhangs, stretch);
    if (stretch.begins_run)
      starts.points(toMetres(kStartWidths * stretch.width_mm)).push_back(toMessage(stretch.points.front()));
  }
  MarkerArray all;
  all.markers.emplace_back();
  all.markers.back().action = Marker::DELETEALL;
  for (MarkerSeries* series : {&overhangs, &bridges, &starts})
    for (Marker& marker : series->finish()) all.markers.push_back(std::move(marker));
  for (Marker& marker : all.markers) marker.header.frame_id = frame;
  return all;
}

}  // namespace lamina
