// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "check_markers.hpp"

#include <string>
#include <utility>
#include <vector>

#include "conversions.hpp"
#include "lamina/toolpath/waypoint_text.hpp"
#include "names.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kDiameter = 2.0;    // mm
constexpr double kText = 6.0;        // mm: height of a letter
constexpr double kTextAbove = 12.0;  // mm

Marker markerOf(const std::string& name, std::int32_t type, float green) {
  Marker marker;
  marker.header.frame_id = names::kPartFrame;
  marker.ns = name;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = toMetres(kDiameter);
  marker.color.r = 0.95F;
  marker.color.g = green;
  marker.color.a = 1.0F;
  return marker;
}

Marker textOf(const Finding& finding) {
  Marker text = markerOf("first_finding", Marker::TEXT_VIEW_FACING, 0.0F);
  text.pose.position = toMessage(Point3(finding.tip + kTextAbove * Point3::UnitZ()));
  text.scale.z = toMetres(kText);
  text.text = toText(finding.at) + ": " + finding.reason;
  return text;
}

void addSpheres(Marker marker, const std::vector<Finding>& findings, MarkerArray& all) {
  for (const Finding& finding : findings) marker.points.push_back(toMessage(finding.tip));
  if (!marker.points.empty()) all.markers.push_back(std::move(marker));
}

}  // namespace

MarkerArray checkMarkers(const MachineCheck& check) {
  MarkerArray all;
  all.markers.push_back(markerOf("", Marker::SPHERE_LIST, 0.0F));
  all.markers.back().action = Marker::DELETEALL;
  addSpheres(markerOf("faulty", Marker::SPHERE_LIST, 0.55F), check.faults, all);
  addSpheres(markerOf("colliding", Marker::SPHERE_LIST, 0.1F), check.collisions, all);
  if (!check.isClear())
    all.markers.push_back(textOf(check.faults.empty() ? check.collisions.front() : check.faults.front()));
  return all;
}

}  // namespace lamina
