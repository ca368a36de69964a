// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "chunk_correction.hpp"
#include "controller_client.hpp"
#include "driver_settings.hpp"
#include "lamina/base/error.hpp"
#include "lamina/streaming/job/packml.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "map_wait.hpp"
#include "messages.hpp"
#include "present_joints.hpp"
#include "process_publisher.hpp"
#include "report_watch.hpp"
#include "tracking.hpp"

namespace lamina {

/// Where a drive is.
struct DriveStatus {
  PackmlState state = PackmlState::Starting;
  double time_s = 0.0;      ///< of the motion, pauses included; not before 0
  double duration_s = 0.0;  ///< of it all, pauses so far included
  WaypointIndex heading_for;
  WaypointIndex handed_over_for;                     ///< the same at the end of what is handed over
  Eigen::Vector3d tip_mm = Eigen::Vector3d::Zero();  ///< [bed frame]
  double feed_share = 1.0;                           ///< of the planned speeds
  double reached_share = 1.0;                        ///< of them that the limits allow on average
  double flow_share = 1.0;                           ///< of the planned material
  double power_share = 1.0;                          ///< of the planned power
  double laid_mm = 0.0;   ///< of the beads, from the start of the toolpath; not before what is reported
  double used_mm3 = 0.0;  ///< of material, in this motion
  double tip_speed_mm_s = 0.0;
  Feeding feeding;
  JointValues joint_error;  ///< actual less wanted [mm, rad]; of size 0 before the motion
  double tip_error_mm = 0.0;
  double worst_tip_error_mm = 0.0;
  double rms_tip_error_mm = 0.0;
  Failure failure;
};

/// What is driven: a toolpath, or the way to its start.
struct DriveMotion {
  const TimedPath& path;
  std::string toolpath_id;
  PackmlState running = PackmlState::Execute;             ///< Starting on the way to the start
  std::shared_ptr<ChunkCorrection> correction = nullptr;  ///< null if it is driven as planned
  ProcessUse process = ProcessUse::AsPlanned;
  double from_mm = 0.0;  ///< of its beads, that are left out with what comes before
};

/// What a drive is connected with.
struct DriveLinks {
  ControllerClient& controller;
  ProcessPublisher& process;
  const PresentJoints& joints;
};

/// One motion on its way through a controller. Its calls may come from several threads.
class DriveSession {
 public:
  /// All that is referred to must outlive the session.
  DriveSession(const DriveMotion& motion, const KinematicModel& model, const DriverSettings& settings,
               const DriveLinks& links);

  /// Hands over what is due. False once the motion has ended and everything is at rest. Gives the motion up
  /// if ROS time has gone back by more than 0.05 s since the last call.
  bool step(const ros::Time& present);
  void hear(const ControllerReport& report, const ros::Time& now);

  /// A map for what is not handed over yet. In front of each layer but the first the motion rests until its
  /// map has come, no longer than `loop.wait_s`.
  /// @return why it is not used, in words; empty if it is
  std::string correct(const CorrectionMap& map, const std::string& digest);
  /// What became of maps since the last call.
  std::vector<DrivenLayer> takeLayers();

  /// The layers left planned anew, to be gone on with in front of the layer that is held for its map, which
  /// must be the one that the plan begins with.
  /// @return why it is not used, in words; empty if it is
  std::string offer(const lamina_msgs::ToolpathConstPtr& plan);
  /// That plan, while the machine rests where it begins, neither paused nor aborted. Null else.
  lamina_msgs::ToolpathConstPtr plan(const ros::Time& now) const;
  /// It cannot be driven: it is not given again.
  void refuse(const std::string& plan_id, const std::string& reason);
  /// Whether the plan is gone over to now: the session is over, can no longer be paused, and the caller
  /// drives the plan.
  bool leaveFor(const std::string& plan_id, const ros::Time& now);

  /// @return why not; nothing if it is done
  std::optional<std::string> pause(const ros::Time& now);
  std::optional<std::string> resume(const ros::Time& now);
  /// The share of what is planned at which it goes on (`TrajectoryFeeder`); on the way to the start no more
  /// than the planned speeds. It takes effect from when it is worked out; of orders of the feed the last
  /// counts, also where an earlier one takes longer.
  /// @return false if a later order of the feed has taken its place
  /// @throws InvalidInput as `TrajectoryFeeder::speedChange` and `setShare`; or in a dry run, if it is no
  /// feed
  bool setShare(OverrideKind kind, double share);
  /// Whether a job is in Execute or held, or goes from one to the other.
  bool isChangeable() const;
  bool isDry() const { return motion_.process == ProcessUse::Off; }
  /// What the feed may be: of dry runs more than `feeder.feed_most`.
  const TrajectoryFeederSettings& feeding() const { return feeding_; }
  /// Brakes along the path, everything of the process off at once. Does nothing if it has ended or is
  /// aborted.
  void abort(const ros::Time& now, const Failure& why);
  /// Ends in Aborted what has not ended, for the caller no longer follows it; the controller is to stop by
  /// itself. Does nothing if a plan is gone over to.
  void leave(const ros::Time& now, const Failure& why);

  DriveStatus status() const;

 private:
  enum class Lift { Yes, No };

  bool isByStamps() const { return settings_.tracking.silence_by == SilenceBy::Stamps; }
  void begin(const ros::Time& now);
  ros::Time followTime(const ros::Time& now);
  bool setSpeed(double share);
  double jobTime(const ros::Time& now) const { return (now - begin_).toSec(); }
  double controllerTime(const ros::Time& now) const;
  bool isRun(const ros::Time& now) const;
  void expectReports(const ros::Time& from);
  void watch(const ros::Time& now);
  void feed(const ros::Time& now);
  void follow(const ros::Time& now);
  void measureLaid(double time_s);
  bool advance(const ros::Time& now);
  bool awaitEnd(const ros::Time& now);
  void awaitMap(const ros::Time& now);
  lamina_msgs::ToolpathConstPtr duePlan(const ros::Time& now) const;
  bool isAtRest(const ros::Time& now) const;
  void brake(const ros::Time& now, const Failure& why, Lift lift);
  void giveUp(const ros::Time& now, const Failure& why);

  const DriveMotion motion_;
  const KinematicModel& model_;
  const DriverSettings& settings_;
  const TrajectoryFeederSettings feeding_;
  const DriveLinks links_;

  mutable std::mutex mutex_;  ///< of what follows up to the reports
  TrajectoryFeeder feeder_;
  ros::Time begin_;                  ///< when the clock of the points is 0; zero before the first are sent
  std::optional<ros::Time> run_at_;  ///< since what is planned is over
  double fed_s_ = 0.0;               ///< end of what was sent
  bool was_starved_ = false;
  double laid_mm3_ = 0.0;        ///< of the beads as planned
  std::optional<MapWait> wait_;  ///< none if it is driven as planned
  bool is_left_ = false;         ///< for a plan
  std::optional<ros::Time> given_up_at_;
  ros::Time stepped_;  ///< the last step; zero before the first
  DriveStatus status_;
  std::uint64_t speed_orders_ = 0;  ///< given so far

  // Reports come while the client of the controller is locked, which is locked too while a chunk is sent.
  mutable std::mutex report_mutex_;
  Tracking tracking_;
  ReportWatch reports_;
  ros::Time reported_;  ///< stamp of the last report; zero before the first
};

}  // namespace lamina
