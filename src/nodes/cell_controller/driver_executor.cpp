// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_executor.hpp"

#include <utility>

#include "conversions.hpp"
#include "driver_language.hpp"
#include "names.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

constexpr const char* kUnanswered = "trajectory_driver does not say where it would resume the job";

const char* nameOf(Placement placement) { return placement == Placement::AsIs ? "as_is" : "centre"; }

}  // namespace

DriverExecutor::DriverExecutor(const ros::NodeHandle& node, Placement placement,
                               std::function<void(const ExecutorReport&)> report)
    : ActionExecutor(node, names::kDriveToolpath, driverLanguage(), std::move(report)),
      placement_(placement),
      place_(ros::NodeHandle(node).serviceClient<lamina_msgs::ResumePlace>(names::kResumePlace)),
      look_(kUnanswered) {}

ExecutorTraits DriverExecutor::traits() const { return {"waypoint", look_.refusal()}; }

void DriverExecutor::lookAtResume(const std::string& program, const ExecutionProgress& progress) {
  const auto job = look_.lookAt(program, progress);
  if (!job) return;
  looks_.give([this, program, job = *job, laid_m = 1e-3 * progress.path_mm] {
    lamina_msgs::ResumePlace call;
    call.request.program = program;
    call.request.placement = nameOf(placement_);
    call.request.laid_length = laid_m;
    if (!callService(place_.getService(), call)) call.response.status.message = kUnanswered;
    ResumeAnswer answer{call.response.status.message, {true, call.response.text}};
    if (answer.refusal.empty()) answer.outlook.begin_mm = toMillimetres(call.response.begin_length);
    look_.answer(job, std::move(answer));
  });
}

ResumeOutlook DriverExecutor::resumeOutlook() const { return look_.outlook(); }

void DriverExecutor::confirmPlace(std::optional<double> begin_mm) {
  confirmed_mm_ = begin_mm ? begin_mm : look_.outlook().begin_mm;
}

lamina_msgs::DriveToolpathGoal DriverExecutor::goalOf(const StartOrder& order) const {
  lamina_msgs::DriveToolpathGoal goal;
  goal.program = order.program;
  goal.placement = nameOf(placement_);
  goal.execution = order.execution;
  goal.resume = order.start != ExecutionStart::Anew && ResumeLook::isOnItsBead(order.progress);
  if (goal.resume) {
    goal.laid_length = 1e-3 * order.progress.path_mm;
    goal.laid_volume = 1e-9 * order.progress.deposited_mm3;
    if (confirmed_mm_) goal.confirmed_length = {toMetres(*confirmed_mm_)};
  }
  return goal;
}

std::uint64_t DriverExecutor::takenThrough(const lamina_msgs::DriveToolpathResult& result) const {
  return result.waypoints;
}

}  // namespace lamina
