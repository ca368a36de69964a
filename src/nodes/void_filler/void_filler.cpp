// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "void_filler.hpp"

#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <limits>
#include <string>
#include <vector>

#include "conversions.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/profiles/stated_settings.hpp"
#include "lamina/job/voids/program_void_job.hpp"
#include "lamina/picture/toolpath_picture.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "progress/service_progress.hpp"
#include "refusal_text.hpp"
#include "request_settings.hpp"
#include "status.hpp"

namespace lamina {
namespace {

double toSquareMetres(double square_millimetres) { return toMetres(toMetres(square_millimetres)); }

std::vector<lamina_msgs::VoidCount> toMessages(const std::map<VoidClass, std::size_t>& counts) {
  std::vector<lamina_msgs::VoidCount> messages;
  for (const auto& [kind, count] : counts) {
    lamina_msgs::VoidCount message;
    message.kind = toString(kind);
    message.count = static_cast<std::uint32_t>(count);
    messages.push_back(message);
  }
  return messages;
}

lamina_msgs::VoidFillingSummary toMessage(const VoidFillingReport& report) {
  lamina_msgs::VoidFillingSummary summary;
  summary.layers = static_cast<std::uint32_t>(report.before.layers);
  summary.layers_filled = static_cast<std::uint32_t>(report.layers);
  summary.voids = static_cast<std::uint32_t>(report.before.voids);
  summary.voids_by_class = toMessages(report.before.voids_by_class);
  summary.runs_added = static_cast<std::uint32_t>(report.runs);
  summary.uncovered_before = toSquareMetres(report.before.uncovered.area_mm2);
  summary.uncovered_after = toSquareMetres(report.after.uncovered.area_mm2);
  summary.overfill_before = toSquareMetres(report.before.overfill.area_mm2);
  summary.overfill_after = toSquareMetres(report.after.overfill.area_mm2);
  summary.is_worth_it = report.runs > 0;
  return summary;
}

lamina_msgs::VoidFillingSummary toMessage(const DropVoidReport& report) {
  lamina_msgs::VoidFillingSummary summary;
  summary.lays_drops = true;
  summary.layers = static_cast<std::uint32_t>(report.voids.size());
  for (const std::vector<DropVoid>& layer : report.voids)
    if (!newDrops(layer).empty()) ++summary.layers_filled;
  summary.voids = static_cast<std::uint32_t>(report.count());
  summary.voids_by_class = toMessages(report.countByClass());
  summary.drops_added = static_cast<std::uint32_t>(report.overlap.added);
  summary.uncovered_before = toSquareMetres(report.uncoveredBefore());
  summary.uncovered_after = toSquareMetres(report.uncoveredAfter());
  summary.greatest_overlap = report.overlap.greatest_linear;
  summary.overlap_per_drop = report.overlap.perDrop();
  summary.layers_without_contour = static_cast<std::uint32_t>(report.layers_without_contour);
  summary.is_worth_it = report.is_worth_it;
  return summary;
}

/// Of the lines round voids between beads [mm].
constexpr double kLineWidth = 0.1;

geometry_msgs::Point at(const Point2& point, double height_mm) {
  return lamina::toMessage(Point3(point.x(), point.y(), height_mm));
}

std::vector<lamina_msgs::FilledVoid> toMessages(const DropVoidReport& report) {
  std::vector<lamina_msgs::FilledVoid> messages;
  for (std::size_t layer = 0; layer < report.voids.size(); ++layer)
    for (const DropVoid& each : report.voids[layer]) {
      lamina_msgs::FilledVoid message;
      message.layer = static_cast<std::uint32_t>(layer);
      message.kind = toString(each.kind);
      message.greatest_clearance = toMetres(each.greatest_clearance_mm);
      message.uncovered_before = toSquareMetres(each.uncovered_before_mm2);
      message.uncovered_after = toSquareMetres(each.uncovered_after_mm2);
      for (const Point2& drop : each.drops) message.drops.push_back(at(drop, report.heights_mm[layer]));
      messages.push_back(std::move(message));
    }
  return messages;
}

std::vector<lamina_msgs::FilledVoid> toMessages(const VoidFillingReport& report) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<lamina_msgs::FilledVoid> messages;
  for (std::size_t layer = 0; layer < report.found.size(); ++layer)
    for (const Void& each : report.found[layer].voids) {
      lamina_msgs::FilledVoid message;
      message.layer = static_cast<std::uint32_t>(layer);
      message.kind = toString(each.kind);
      message.greatest_clearance = message.uncovered_after = kUnknown;
      message.uncovered_before = toSquareMetres(each.area_mm2);
      for (const Point2& point : each.outline.outer)
        message.outline.push_back(at(point, report.found[layer].z_mm));
      messages.push_back(std::move(message));
    }
  return messages;
}

using visualization_msgs::Marker;

Marker markerOf(VoidClass kind, const Colour& colour) {
  Marker marker;
  marker.ns = toString(kind);
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = 1;  // it goes where the part is put next, and with a table that moves
  marker.color.r = static_cast<float>(colour.red);
  marker.color.g = static_cast<float>(colour.green);
  marker.color.b = static_cast<float>(colour.blue);
  marker.color.a = 1.0F;
  return marker;
}

Marker markerOf(const DropVoidReport& report, VoidClass kind) {
  Marker marker = markerOf(kind, roleColour(PathRole::GapFill));
  marker.type = Marker::SPHERE_LIST;
  marker.scale.x = marker.scale.y = marker.scale.z = toMetres(report.diameter_mm);
  for (std::size_t layer = 0; layer < report.voids.size(); ++layer)
    for (const DropVoid& each : report.voids[layer])
      for (const Point2& drop : each.drops)
        if (each.kind == kind) marker.points.push_back(at(drop, report.heights_mm[layer]));
  return marker;
}

void addLoop(const Polygon& loop, double height_mm, Marker& marker) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    marker.points.push_back(at(loop[i], height_mm));
    marker.points.push_back(at(loop[(i + 1) % loop.size()], height_mm));
  }
}

Marker markerOf(const VoidFillingReport& report, VoidClass kind) {
  Marker marker = markerOf(kind, roleColour(PathRole::GapFill));
  marker.type = Marker::LINE_LIST;
  marker.scale.x = toMetres(kLineWidth);
  for (const LayerVoids& layer : report.found)
    for (const Void& each : layer.voids) {
      if (each.kind != kind) continue;
      addLoop(each.outline.outer, layer.z_mm, marker);
      for (const Polygon& hole : each.outline.holes) addLoop(hole, layer.z_mm, marker);
    }
  return marker;
}

lamina_msgs::VoidFillingSummary toMessage(const ProgramVoidReport& report) {
  return std::visit([](const auto& each) { return toMessage(each); }, report);
}

/// Each void of each layer.
std::vector<lamina_msgs::FilledVoid> toMessages(const ProgramVoidReport& report) {
  return std::visit([](const auto& each) { return toMessages(each); }, report);
}

/// Of drops the new ones as spheres, of beads lines round the voids that were found; one namespace per class
/// of void. The first marker deletes those of an earlier program.
visualization_msgs::MarkerArray voidMarkers(const ProgramVoidReport& report, const std::string& frame) {
  visualization_msgs::MarkerArray array;
  array.markers.emplace_back();
  array.markers.back().action = Marker::DELETEALL;
  for (const VoidClass kind : kVoidClasses) {
    Marker marker = std::visit([kind](const auto& each) { return markerOf(each, kind); }, report);
    if (!marker.points.empty()) array.markers.push_back(std::move(marker));
  }
  for (Marker& marker : array.markers) marker.header.frame_id = frame;
  return array;
}

}  // namespace

VoidFiller::VoidFiller(ros::NodeHandle node, const JobSettings& settings)
    : settings_(settings),
      markers_(node.advertise<visualization_msgs::MarkerArray>(names::kVoidMarkers, 1, true)),
      service_(node.advertiseService(names::kFillVoids, &VoidFiller::onService, this)) {}

bool VoidFiller::onService(lamina_msgs::FillVoids::Request& request,
                           lamina_msgs::FillVoids::Response& response) {
  try {
    const std::unique_lock<std::mutex> lock(job_, std::try_to_lock);
    if (!lock) throw Rejected("another program is being filled; wait for it");
    ROS_INFO_STREAM("filling the voids of '" << request.program << "'");
    response = fill(request);
    ROS_INFO_STREAM("filled '" << request.program << "': " << response.summary.voids << " voids, "
                               << response.summary.runs_added << " runs and " << response.summary.drops_added
                               << " drops added");
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"fill the voids of", request.program, request.output}, failure));
    response = {};
    response.status = toMessage(failure);
  }
  return true;
}

lamina_msgs::FillVoids::Response VoidFiller::fill(const lamina_msgs::FillVoids::Request& request) {
  ProgramVoidJob job{request.program, request.output, request.part, settings_};
  SettingsSchema schema;
  describe(schema, job.settings);
  applyRequest(schema, request.settings);
  std::vector<SettingText> typed;
  typed.reserve(request.settings.size());
  for (const lamina_msgs::Setting& setting : request.settings) typed.push_back({setting.key, setting.value});
  job.settings.program.is_diameter_given = givesFilamentDiameter(typed);
  job.settings = withStatedShrinkage(job.settings, request.program, typed);
  ServiceProgress progress;
  const ProgramVoidReport report = runProgramVoidJob(job, progress);
  lamina_msgs::FillVoids::Response response;
  response.summary = toMessage(report);
  response.voids = toMessages(report);
  publishLatched(markers_, voidMarkers(report, names::kBedFrame));
  return response;
}

}  // namespace lamina
