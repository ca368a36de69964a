// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "chunk_correction.hpp"
#include "controller_client.hpp"
#include "drive_clock.hpp"
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

/// Progress of a drive.
struct DriveStatus {
  PackmlState state = PackmlState::Starting;
  double time_s = 0.0;      ///< of the motion, pauses included; not before 0
  double duration_s = 0.0;  ///< of the whole motion, pauses so far included
  WaypointIndex heading_for;
  WaypointIndex handed_over_for;                     ///< the same at the end of what is handed over
  Eigen::Vector3d tip_mm = Eigen::Vector3d::Zero();  ///< [bed frame]
  double feed_share = 1.0;                           ///< of the planned speeds
  double reached_share = 1.0;  ///< share of the planned speeds that the limits allow on average
  double flow_share = 1.0;     ///< of the planned material
  double power_share = 1.0;    ///< of the planned power
  double laid_mm = 0.0;        ///< length of the beads from the start of the toolpath, reported as laid
  double used_mm3 = 0.0;       ///< volume of material, in this motion
  double tip_speed_mm_s = 0.0;
  Feeding feeding;
  JointValues joint_error;  ///< actual less wanted [mm, rad]; of size 0 before the motion
  double tip_error_mm = 0.0;
  double worst_tip_error_mm = 0.0;
  double rms_tip_error_mm = 0.0;
  Failure failure;
};

/// The motion that is driven: a toolpath, or the approach to its start.
struct DriveMotion {
  const TimedPath& path;
  std::string toolpath_id;
  PackmlState running = PackmlState::Execute;             ///< Starting during the approach
  std::shared_ptr<ChunkCorrection> correction = nullptr;  ///< null if it is driven as planned
  ProcessUse process = ProcessUse::AsPlanned;
  double from_mm = 0.0;  ///< of its beads, that are left out with what comes before
};

/// The connections of a drive.
struct DriveLinks {
  ControllerClient& controller;
  ProcessPublisher& process;
  const PresentJoints& joints;
  /// Read while the session is locked: an instant from before a wait for it would be past.
  std::function<DriveInstant()> clock = presentInstant;
};

/// One motion that is run by a controller. Its calls may come from several threads.
class DriveSession {
 public:
  /// The objects referred to must outlive the session.
  DriveSession(const DriveMotion& motion, const KinematicModel& model, const DriverSettings& settings,
               const DriveLinks& links);

  /// Hands over the chunks that are due. Returns false once the motion has ended and everything is at rest.
  /// Gives the motion up if ROS time has gone back by more than 0.05 s since the last call, or has been set
  /// by more than that since the first one: process and motion would no longer go by the same time.
  bool step();
  void hear(const ControllerReport& report, const ros::Time& now);

  /// Takes a map for chunks that are not handed over yet. In front of each layer except the first the motion
  /// rests until the layer's map has come, no longer than `loop.wait_s`.
  /// @return why it is not used, in words; empty if it is
  std::string correct(const CorrectionMap& map, const std::string& digest);
  /// Outcomes of maps since the last call.
  std::vector<DrivenLayer> takeLayers();

  /// Takes a new plan of the remaining layers, to be followed from the layer that is held for its map; this
  /// must be the plan's first layer.
  /// @return why it is not used, in words; empty if it is
  std::string offer(const lamina_msgs::ToolpathConstPtr& plan);
  /// The offered plan, while the machine rests at its beginning, neither paused nor aborted; otherwise null.
  lamina_msgs::ToolpathConstPtr plan() const;
  /// States that the plan cannot be driven: it is not returned again.
  void refuse(const std::string& plan_id, const std::string& reason);
  /// Whether the motion changes to the plan now: the session is then over, can no longer be paused, and the
  /// caller drives the plan.
  bool leaveFor(const std::string& plan_id);

  /// @return why not; nothing if it is done
  std::optional<std::string> pause();
  /// Refuses where the joints are not as they were handed over last: a controller that does not look where it
  /// starts from would leap back through the part. Waits for their reports, no longer than
  /// `controller_wait_s`.
  std::optional<std::string> resume();
  /// Sets the share of the planned values at which the motion continues (`TrajectoryFeeder`); during the
  /// approach at most the planned speeds. The share takes effect once it is computed; of several orders of
  /// the feed the last one holds, even if an earlier one takes longer to compute.
  /// @return false if a later order of the feed has replaced it
  /// @throws InvalidInput as `TrajectoryFeeder::speedChange` and `setShare`; or in a dry run, if it is no
  ///   feed
  bool setShare(OverrideKind kind, double share);
  /// Whether a job is in Execute or held, or goes from one to the other.
  bool isChangeable() const;
  bool isDry() const { return motion_.process == ProcessUse::Off; }
  /// Limits of the feed; in dry runs it may be above `feeder.feed_most`.
  const TrajectoryFeederSettings& feeding() const { return feeding_; }
  /// Brakes along the path, and switches off the whole process at once. Does nothing if the motion has ended
  /// or is aborted.
  void abort(const Failure& why);
  /// Ends a motion that has not ended in Aborted, since the caller no longer follows it; the controller must
  /// stop by itself. Does nothing if the motion has changed to a plan.
  void leave(const Failure& why);

  DriveStatus status() const;

 private:
  enum class Lift { Yes, No };

  bool isByStamps() const { return settings_.tracking.silence_by == SilenceBy::Stamps; }
  void begin(const ros::Time& now);
  ros::Time followTime(const DriveInstant& present);
  void watchClock(const DriveInstant& present);
  bool setSpeed(double share);
  double jobTime(const ros::Time& now) const { return (now - begin_).toSec(); }
  double controllerTime(const ros::Time& now) const;
  double heardTime() const;
  bool isRun(const ros::Time& now) const;
  void expectReports(const ros::Time& from);
  void watch(const ros::Time& now);
  std::string displacement() const;
  bool hasRunDry(const ros::Time& now) const;
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
  std::optional<ros::Time> run_at_;  ///< time at which the planned motion ended
  double fed_s_ = 0.0;               ///< end of the chunks that were sent
  JointValues fed_to_;               ///< where they end; of size 0 before the first
  bool was_starved_ = false;
  double laid_mm3_ = 0.0;  ///< volume of the laid beads as planned
  /// When an abort has switched the process off: the way to rest lays nothing [s].
  double off_s_ = std::numeric_limits<double>::infinity();
  std::optional<MapWait> wait_;  ///< nothing if the motion is driven as planned
  bool is_left_ = false;         ///< whether the session was left for a plan
  std::optional<ros::Time> given_up_at_;
  ros::Time stepped_;                       ///< the last step; zero before the first
  std::optional<DriveInstant> first_step_;  ///< that both clocks were read at
  DriveStatus status_;
  std::uint64_t speed_orders_ = 0;  ///< given so far

  // Reports arrive while the controller's client is locked; the client is also locked while a chunk is sent.
  mutable std::mutex report_mutex_;
  Tracking tracking_;
  ReportWatch reports_;
  ros::Time reported_;  ///< stamp of the last report; zero before the first
  ros::Time heard_;     ///< when the last report came; zero before the first
};

}  // namespace lamina
