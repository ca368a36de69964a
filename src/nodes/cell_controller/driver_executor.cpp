// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_executor.hpp"

#include <utility>

#include "conversions.hpp"
#include "driver_language.hpp"
#include "lamina/base/number_text.hpp"
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
      refusal_(kUnanswered) {}

ExecutorTraits DriverExecutor::traits() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {"waypoint", refusal_};
}

void DriverExecutor::lookAtResume(const std::string& program, const ExecutionProgress& progress) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::string job = program + ' ' + numberText(progress.path_mm);
    if (job != job_) {
      refusal_ = kUnanswered;
      outlook_ = {true, "", {}};
      job_ = std::move(job);
    }
    if (std::exchange(is_asked_, true)) return;
  }
  looks_.give([this, program, laid_m = 1e-3 * progress.path_mm] {
    lamina_msgs::ResumePlace call;
    call.request.program = program;
    call.request.placement = nameOf(placement_);
    call.request.laid_length = laid_m;
    if (!callService(place_.getService(), call)) call.response.status.message = kUnanswered;
    const std::lock_guard<std::mutex> lock(mutex_);
    refusal_ = call.response.status.message;
    outlook_ = {true, call.response.text, {}};
    if (refusal_.empty()) outlook_.begin_mm = toMillimetres(call.response.begin_length);
    is_asked_ = false;
  });
}

ResumeOutlook DriverExecutor::resumeOutlook() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return outlook_;
}

void DriverExecutor::confirmPlace(std::optional<double> begin_mm) {
  const std::lock_guard<std::mutex> lock(mutex_);
  confirmed_mm_ = begin_mm ? begin_mm : outlook_.begin_mm;
}

lamina_msgs::DriveToolpathGoal DriverExecutor::goalOf(const StartOrder& order) const {
  lamina_msgs::DriveToolpathGoal goal;
  goal.program = order.program;
  goal.placement = nameOf(placement_);
  goal.execution = order.execution;
  // Of which nothing was reported as handed over, nothing was laid.
  goal.resume = order.start != ExecutionStart::Anew && order.progress.sent_through > 0;
  if (goal.resume) {
    goal.laid_length = 1e-3 * order.progress.path_mm;
    goal.laid_volume = 1e-9 * order.progress.deposited_mm3;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (confirmed_mm_) goal.confirmed_length = {toMetres(*confirmed_mm_)};
  }
  return goal;
}

std::uint64_t DriverExecutor::takenThrough(const lamina_msgs::DriveToolpathResult& result) const {
  return result.waypoints;
}

}  // namespace lamina
