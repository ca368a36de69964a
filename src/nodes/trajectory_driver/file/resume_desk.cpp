// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "file/resume_desk.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "file/driven_file.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "names.hpp"
#include "status.hpp"

namespace lamina {
namespace {

constexpr double kAge = 1.0;         // s of what is known of the joints
constexpr double kAtRest = 0.2;      // s for which they have to be still
constexpr double kLook = 0.02;       // s between looks
constexpr double kUnreported = 2.0;  // s between two reports that are kept, at most
constexpr double kBehind = 2.0;      // mm by which a machine may trail, whatever its tracking limit

/// How far the machine may be from what was reported. A driver whose cell is gone drives on for the grace; a
/// controller whose driver is gone runs what it was handed over.
ReportedProgress reportedProgress(const DriverSettings& settings, const LaidBeads& beads, double laid_mm) {
  const TrajectoryFeederSettings& feeder = settings.feeder;
  double unheard_s = kUnreported + feeder.ahead_s + feeder.points / feeder.rate_hz;
  if (!settings.owner.empty()) unheard_s += settings.owner_grace_s;
  ReportedProgress reported;
  reported.laid_mm = laid_mm;
  reported.behind_mm = std::max(kBehind, settings.tracking.tip_mm);
  reported.ahead_mm = unheard_s * beads.greatestFeed();
  if (settings.lift_mm > 0.0) reported.most_rise_mm = 0.5 * settings.lift_mm;
  return reported;
}

}  // namespace

ResumeDesk::ResumeDesk(const ros::NodeHandle& node, const DriverSettings& settings,
                       const KinematicModel& model, const PresentJoints& joints,
                       std::function<bool()> is_driving)
    : settings_(settings),
      model_(model),
      joints_(joints),
      is_driving_(std::move(is_driving)),
      spinner_(1, &queue_) {
  ros::NodeHandle own(node);
  own.setCallbackQueue(&queue_);
  server_ = own.advertiseService(names::kResumePlace, &ResumeDesk::onAsked, this);
  spinner_.start();
}

void ResumeDesk::depart(const JointValues& here) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!rested_) rested_ = here;
}

void ResumeDesk::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  rested_.reset();
}

JointValues ResumeDesk::rest(double wait_s) const {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (rested_) return *rested_;
  }
  const SteadyClock clock;
  const double until_s = clock.now() + wait_s;
  for (;;) {
    JointValues here = joints_.fresh(kAge, std::max(0.0, until_s - clock.now()));
    if (joints_.areStillFor(kAtRest)) return here;
    if (clock.now() >= until_s)
      throw DeviceError("the machine still moves; expected it at rest, where the job that was cut off ended");
    ros::WallDuration(kLook).sleep();
  }
}

/// Where heights were corrected or layers planned anew, the file does not say where the nozzle was.
void ResumeDesk::requireResumable() const {
  if (settings_.is_corrected)
    throw InvalidInput(
        "with corrections.use heights may have been corrected and layers planned anew, which the file does "
        "not "
        "have; discard the job");
}

ResumePlace ResumeDesk::placeBy(const LaidBeads& beads, const Eigen::Isometry3d& bed_from_part, double laid_m,
                                double wait_s) const {
  const Eigen::Isometry3d nozzle = bed_from_part.inverse() * model_.bedFromNozzle(rest(wait_s));
  return resumePlace(beads, reportedProgress(settings_, beads, toMillimetres(laid_m)), nozzle,
                     settings_.resume);
}

std::optional<ResumePlace> ResumeDesk::placeOf(const lamina_msgs::DriveToolpathGoal& goal,
                                               const MachineToolpath& placed) const {
  const std::vector<std::uint32_t>& from = goal.from_waypoint;
  if (goal.confirmed_length.size() > (goal.resume ? 1U : 0U))
    throw InvalidInput("confirmed_length has " + std::to_string(goal.confirmed_length.size()) +
                       " numbers; expected one at most, with resume");
  if (!goal.resume && from.empty()) return std::nullopt;
  const LaidBeads beads(placed.toolpath);
  if (!goal.resume) {
    if (from.size() != 3)
      throw InvalidInput("from_waypoint has " + std::to_string(from.size()) +
                         " numbers; expected layer, path and waypoint");
    const double begin_mm = beads.before({from[0], from[1], from[2]});
    return ResumePlace{begin_mm, begin_mm, false, beads.headingFor(begin_mm), beads.total(), 0.0};
  }
  if (goal.program.empty() || !goal.dry.empty() || !from.empty())
    throw InvalidInput("resume is asked for; expected a program, no dry run and no from_waypoint with it");
  if (!std::isfinite(goal.laid_volume) || goal.laid_volume < 0.0)
    throw InvalidInput("laid_volume is " + numberText(goal.laid_volume) + " m3; expected 0 m3 or more");
  requireResumable();
  ResumePlace place = placeBy(beads, placed.bed_from_part, goal.laid_length, settings_.controller_wait_s);
  if (!goal.confirmed_length.empty()) requireConfirmed(place, toMillimetres(goal.confirmed_length.front()));
  ROS_WARN_STREAM("the job is resumed: " << toText(place));
  return place;
}

ResumeDesk::FileKey ResumeDesk::keyOf(const lamina_msgs::ResumePlace::Request& request) {
  // A file that cannot be looked at is refused as it is read.
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(request.program, error);
  return {request.placement + ' ' + request.program, size,
          std::filesystem::last_write_time(request.program, error)};
}

std::shared_ptr<const ResumeDesk::ReadFile> ResumeDesk::fileOf(
    const lamina_msgs::ResumePlace::Request& request) {
  FileKey key = keyOf(request);
  if (read_ && read_->key == key) return read_;
  lamina_msgs::DriveToolpathGoal goal;
  goal.program = request.program;
  goal.placement = request.placement;
  const MachineToolpath placed = toolpathOfFile(goal, settings_.machine);
  read_ = std::make_shared<const ReadFile>(
      ReadFile{std::move(key), placed.bed_from_part, LaidBeads(placed.toolpath)});
  return read_;
}

bool ResumeDesk::onAsked(lamina_msgs::ResumePlace::Request& request,
                         lamina_msgs::ResumePlace::Response& response) {
  try {
    requireResumable();
    if (is_driving_())
      throw DeviceError(
          "a job still moves the machine, or holds it; expected it at rest, where the job that was cut off "
          "ended");
    rest(0.0);  // a large file is not read for nothing
    const std::shared_ptr<const ReadFile> file = fileOf(request);
    const ResumePlace place = placeBy(file->beads, file->bed_from_part, request.laid_length, 0.0);
    response.is_found = place.is_found;
    response.begin_length = toMetres(place.begin_mm);
    response.layer = static_cast<std::uint32_t>(place.heading_for.layer);
    response.path = static_cast<std::uint32_t>(place.heading_for.path);
    response.waypoint = static_cast<std::uint32_t>(place.heading_for.waypoint);
    response.text = toText(place);
  } catch (...) {
    response.status = toMessage(currentFailure());
  }
  return true;
}

}  // namespace lamina
