// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/check_markers.hpp"

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

constexpr double kDiameter = 2.0;         // mm
constexpr double kCheckText = 6.0;        // mm: height of a letter
constexpr double kCheckTextAbove = 12.0;  // mm

Marker checkMarkerOf(const std::string& name, std::int32_t type, float green) {
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

Marker checkTextOf(const Finding& finding) {
  Marker text = checkMarkerOf("first_finding", Marker::TEXT_VIEW_FACING, 0.0F);
  text.pose.position = toMessage(Point3(finding.tip + kCheckTextAbove * Point3::UnitZ()));
  text.scale.z = toMetres(kCheckText);
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
  all.markers.push_back(checkMarkerOf("", Marker::SPHERE_LIST, 0.0F));
  all.markers.back().action = Marker::DELETEALL;
  addSpheres(checkMarkerOf("faulty", Marker::SPHERE_LIST, 0.55F), check.faults, all);
  addSpheres(checkMarkerOf("colliding", Marker::SPHERE_LIST, 0.1F), check.collisions, all);
  if (!check.isClear())
    all.markers.push_back(
        checkTextOf(check.faults.empty() ? check.collisions.front() : check.faults.front()));
  return all;
}

}  // namespace lamina
