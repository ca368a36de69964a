// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drive_messages.hpp"

#include <algorithm>
#include <cmath>

#include "conversions.hpp"
#include "status.hpp"

namespace lamina {

lamina_msgs::DriveToolpathFeedback toFeedback(const DriveStatus& status) {
  lamina_msgs::DriveToolpathFeedback feedback;
  feedback.state = toString(status.state);
  feedback.layer = static_cast<std::uint32_t>(status.heading_for.layer);
  feedback.path = static_cast<std::uint32_t>(status.heading_for.path);
  feedback.waypoint = static_cast<std::uint32_t>(status.heading_for.waypoint);
  const bool is_known = status.duration_s > 0.0;
  feedback.fraction = is_known ? static_cast<float>(std::min(1.0, status.time_s / status.duration_s)) : 0.0F;
  return feedback;
}

lamina_msgs::DriveToolpathResult toResult(const DriveStatus& status) {
  lamina_msgs::DriveToolpathResult result;
  result.status = toMessage(status.failure);
  result.duration = status.time_s;
  result.worst_tip_error = toMetres(status.worst_tip_error_mm);
  result.rms_tip_error = toMetres(status.rms_tip_error_mm);
  result.starvations = static_cast<std::uint32_t>(status.feeding.starvations);
  return result;
}

lamina_msgs::MachineState toMachineState(const DriveStatus& status, const std::string& job) {
  lamina_msgs::MachineState message;
  message.state = static_cast<std::uint8_t>(status.state);
  message.state_name = toString(status.state);
  message.job = job;
  message.layer = static_cast<std::int32_t>(status.heading_for.layer);
  message.position = toMessage(Point3(status.tip_mm));
  message.status = toMessage(status.failure);
  return message;
}

lamina_msgs::PrintProgress toPrintProgress(const DriveStatus& status, const std::string& job) {
  lamina_msgs::PrintProgress message;
  message.job = job;
  message.laid_length = toMetres(status.laid_mm);
  message.laid_volume = 1e-9 * status.used_mm3;
  message.tip_speed = toMetres(status.tip_speed_mm_s);
  return message;
}

lamina_msgs::TrackingError toTrackingError(const DriveStatus& status, const KinematicModel& model) {
  lamina_msgs::TrackingError message;
  for (Eigen::Index j = 0; j < status.joint_error.size(); ++j) {
    const DrivenJoint& joint = model.joints()[static_cast<std::size_t>(j)];
    const double error = status.joint_error[j];
    message.joint_names.push_back(joint.name);
    message.error.push_back(joint.kind == JointKind::Linear ? toMetres(error) : error);
  }
  message.tip_error = toMetres(status.tip_error_mm);
  message.worst_tip_error = toMetres(status.worst_tip_error_mm);
  message.rms_tip_error = toMetres(status.rms_tip_error_mm);
  message.starvations = static_cast<std::uint32_t>(status.feeding.starvations);
  message.least_queued = std::isfinite(status.feeding.least_queued_s) ? status.feeding.least_queued_s : 0.0;
  return message;
}

void fillDiagnostics(const DriveStatus& status, diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  using diagnostic_msgs::DiagnosticStatus;
  const bool is_well = status.failure.code == ErrorCode::Ok || status.failure.code == ErrorCode::Cancelled;
  if (!is_well)
    diagnostics.summary(DiagnosticStatus::ERROR, status.failure.message);
  else
    diagnostics.summary(status.feeding.starvations > 0 ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                        toString(status.state));
  diagnostics.add("state", toString(status.state));
  diagnostics.add("layer", status.heading_for.layer);
  diagnostics.add("time [s]", status.time_s);
  diagnostics.add("time in all [s]", status.duration_s);
  diagnostics.add("speed, of that planned", status.feed_share);
  diagnostics.add("speed that the limits allow, of that planned", status.reached_share);
  diagnostics.add("flow, of that planned", status.flow_share);
  diagnostics.add("power, of that planned", status.power_share);
  diagnostics.add("tip error [mm]", status.tip_error_mm);
  diagnostics.add("worst tip error [mm]", status.worst_tip_error_mm);
  diagnostics.add("starvations", status.feeding.starvations);
  diagnostics.add("least motion queued [s]", status.feeding.least_queued_s);
}

}  // namespace lamina
