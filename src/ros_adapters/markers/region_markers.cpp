// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/region_markers.hpp"

#include "conversions.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::size_t kLineLength = 60;
constexpr double kLetterShare = 0.025;  // of the part's diagonal

std_msgs::ColorRGBA regionColour(float red, float green, float blue, float alpha) {
  std_msgs::ColorRGBA message;
  message.r = red;
  message.g = green;
  message.b = blue;
  message.a = alpha;
  return message;
}

Marker markerOf(const std::string& frame, const std::string& name_space, std::int32_t type) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = name_space;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = 1;  // it goes where the part is put next, and with a table that moves
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  return marker;
}

Marker facesOf(const Mesh& mesh, Marker marker) {
  marker.points.reserve(3 * mesh.triangles.size());
  for (const Triangle& corner : mesh.triangles)
    for (const std::uint32_t vertex : corner) marker.points.push_back(toMessage(mesh.vertices[vertex]));
  return marker;
}

/// A marker a line: RViz sets the lines of one marker far apart whatever their size.
void addReason(MarkerArray& markers, const Box3& box, const std::string& text, const std::string& frame) {
  const double letter_mm = kLetterShare * box.size().norm();
  const std::vector<std::string> lines = brokenInto(kLineLength, text);
  Point3 place(box.centre().x(), box.centre().y(),
               box.high.z() + 1.5 * letter_mm * static_cast<double>(lines.size()));
  for (const std::string& line : lines) {
    Marker marker = markerOf(frame, "reason", Marker::TEXT_VIEW_FACING);
    marker.id = static_cast<std::int32_t>(markers.markers.size());
    marker.color = regionColour(0.15F, 0.15F, 0.15F, 1.0F);
    marker.text = line;
    marker.scale.z = toMetres(letter_mm);
    marker.pose.position = toMessage(place);
    markers.markers.push_back(marker);
    place.z() -= 1.4 * letter_mm;
  }
}

}  // namespace

MarkerArray noRegionMarkers(const std::string& frame) {
  MarkerArray markers;
  markers.markers.emplace_back();
  markers.markers.back().header.frame_id = frame;
  markers.markers.back().action = Marker::DELETEALL;
  return markers;
}

MarkerArray regionMarkers(const Unsliceable& refusal, const std::string& frame) {
  MarkerArray markers = noRegionMarkers(frame);
  Marker region = markerOf(frame, "region", Marker::TRIANGLE_LIST);
  region.color = regionColour(0.85F, 0.1F, 0.1F, 1.0F);
  Marker part = markerOf(frame, "part", Marker::TRIANGLE_LIST);
  part.color = regionColour(0.7F, 0.72F, 0.76F, 0.4F);
  if (!refusal.region().triangles.empty()) markers.markers.push_back(facesOf(refusal.region(), region));
  if (!refusal.part().triangles.empty()) markers.markers.push_back(facesOf(refusal.part(), part));
  Box3 box = boundingBox(refusal.part());
  for (const Point3& vertex : refusal.region().vertices) box.include(vertex);
  if (box.isEmpty()) return markers;
  addReason(markers, box, refusal.what(), frame);
  return markers;
}

}  // namespace lamina
