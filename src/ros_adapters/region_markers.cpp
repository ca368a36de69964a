// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "region_markers.hpp"

#include "conversions.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

std_msgs::ColorRGBA colour(float red, float green, float blue, float alpha) {
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
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  return marker;
}

Marker facesOf(const Mesh& mesh, Marker marker) {
  marker.points.reserve(3 * mesh.triangles.size());
  for (const Triangle& corner : mesh.triangles)
    for (const std::uint32_t vertex : corner) marker.points.push_back(toMessage(mesh.vertices[vertex]));
  return marker;
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
  region.color = colour(0.85F, 0.1F, 0.1F, 1.0F);
  Marker part = markerOf(frame, "part", Marker::TRIANGLE_LIST);
  part.color = colour(0.7F, 0.72F, 0.76F, 0.4F);
  if (!refusal.region().triangles.empty()) markers.markers.push_back(facesOf(refusal.region(), region));
  if (!refusal.part().triangles.empty()) markers.markers.push_back(facesOf(refusal.part(), part));
  Box3 box = boundingBox(refusal.part());
  for (const Point3& vertex : refusal.region().vertices) box.include(vertex);
  if (box.isEmpty()) return markers;
  Marker reason = markerOf(frame, "reason", Marker::TEXT_VIEW_FACING);
  reason.color = colour(0.15F, 0.15F, 0.15F, 1.0F);
  reason.text = refusal.what();
  reason.scale.z = toMetres(0.04 * box.size().norm());
  reason.pose.position =
      toMessage(Point3(box.centre().x(), box.centre().y(), box.high.z() + 0.1 * box.size().norm()));
  markers.markers.push_back(reason);
  return markers;
}

}  // namespace lamina
