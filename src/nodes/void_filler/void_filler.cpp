// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "void_filler.hpp"

#include <ros/ros.h>

#include "lamina/base/error.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "progress/service_progress.hpp"
#include "refusal_text.hpp"
#include "request_settings.hpp"
#include "status.hpp"
#include "void_messages.hpp"

namespace lamina {
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
  ServiceProgress progress;
  const ProgramVoidReport report = runProgramVoidJob(job, progress);
  lamina_msgs::FillVoids::Response response;
  response.summary = toMessage(report);
  response.voids = toMessages(report);
  publishLatched(markers_, voidMarkers(report, names::kBedFrame));
  return response;
}

}  // namespace lamina
