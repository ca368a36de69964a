// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/toolpath/job_override.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "lamina/trajectory/trajectory_feeder_settings.hpp"

namespace lamina {

/// Consecutive points of a trajectory, at times of the job. The first one lies on the motion that was handed
/// over before. The points replace all that the controller still has from that time on.
struct TrajectoryChunk {
  std::vector<JointState> points;
};

enum class TrajectoryFeederState : std::uint8_t {
  Running,
  Paused,    ///< on the way to rest, or at rest
  Aborted,   ///< the same for good, lifted if asked
  Finished,  ///< the last point has been handed over
};

class SpeedPlan;

/// The reason why a motion cannot go on at a share of its planned speeds; empty if it can. Shares lie between
/// 0.01 and `feeder.feed_most`.
std::string speedRefusal(double share, const TrajectoryFeederSettings& settings);

/// A share of the planned speeds, and the plan worked out for it.
struct SpeedChange {
  double share = 1.0;
  double reached = 1.0;  ///< share of the planned speeds that the limits allow, on average over the motion
  std::shared_ptr<const SpeedPlan> plan;  ///< null for the planned speeds and for slower ones
};

/// How the tool is lifted clear after an abort.
struct ToolLift {
  double height_mm = 0.0;  ///< against the tool axis
  double speed_mm_s = 0.0;
};

/// Hands a trajectory to a controller piece by piece. All times are of one clock that was 0 at the start of
/// the job. Pausing brakes along the path as hard as the limits allow and stays on it; resuming goes on from
/// there, so that everything is deposited once. At rest after a pause, and at once after an abort, the
/// process is safe: flow, laser, wire, powder and gas are off.
class TrajectoryFeeder {
 public:
  /// @throws InvalidConfig naming key, value and bound
  TrajectoryFeeder(const TimedPath& path, const TrajectoryFeederSettings& settings);
  ~TrajectoryFeeder();
  TrajectoryFeeder(TrajectoryFeeder&&) noexcept;
  TrajectoryFeeder& operator=(TrajectoryFeeder&&) noexcept;

  /// The next chunk, if the controller has less than the motion ahead and a chunk; nothing if it has enough
  /// or there is no more. To be called until it gives nothing, at least once per duration of a chunk.
  std::optional<TrajectoryChunk> next(double now_s);

  /// Does nothing unless running, or if the motion ends before it could react. A motion that is held in front
  /// of a layer stays held.
  void pause(double now_s);
  /// Powder and gas settle first. A motion that was paused while held in front of a layer is held there
  /// again. Does nothing unless paused.
  void resume(double now_s);
  /// Works out a change of the speed for `setSpeed`. Takes linear time for more than the planned speeds, else
  /// none. May be called while other threads use the feeder.
  /// @throws InvalidInput as `speedRefusal`
  SpeedChange speedChange(double share) const;
  /// Goes on at a share of the planned speeds, on the same path, from the first point that can still change.
  /// The motion first brakes or speeds up as hard as the limits allow. Below the planned speeds it is then
  /// slower by one factor everywhere, so that no limit of a joint can be passed. Above them it is as fast as
  /// the share of the feeds asks, where the limits of joints, path and roundings allow that. Rests keep their
  /// duration. A change while paused or at rest takes effect on resuming. In front of a layer that is waited
  /// for, the motion stops as before. The flow follows the speed.
  void setSpeed(const SpeedChange& change, double now_s);
  /// The same, worked out at once.
  /// @param share  1 at the start
  /// @throws InvalidInput as `speedRefusal`; nothing changes
  void setSpeed(double share, double now_s);
  /// Lays a share of the planned material (flow, wire, screw, powder), or burns with a share of the planned
  /// power, from the first point that can still change. The transition takes `feeder.override_ramp_s` times
  /// the change. The motion stays.
  /// @throws InvalidInput if the share is out of `boundsOf`, is one of the feed, or one of the power where
  ///   the toolpath states none; nothing changes
  void setShare(JobOverride kind, double share, double now_s);
  /// Stops where a layer begins, and rests there until it is released: at the end of what comes before, or on
  /// the travel that the layer begins with. The motion before that place stays as it is. A pause that comes
  /// to rest before the layer cancels the stop.
  /// @return false if it is not running, has no such layer, cannot stop in front of it any more, or would
  /// have
  ///   to stop on the layer's first bead, which goes on from what comes before; then nothing happens
  bool holdAtLayer(std::size_t layer, double now_s);
  /// Goes on into the layer; powder and gas settle first. Does nothing unless it is running and held.
  void release(double now_s);
  /// Whether it stops in front of a layer, or rests there, paused or not.
  bool isHeld() const;
  /// Does nothing after the end of the motion or an abort.
  void abort(double now_s);
  /// The same, with the tool lifted after it has come to rest.
  /// @throws Unreachable if a joint would leave its limits on the way; the abort stands without the lift
  void abort(double now_s, const ToolLift& lift, const KinematicModel& model);

  TrajectoryFeederState state() const;
  /// When the motion that is planned now is at rest [s].
  double restTime() const;
  /// Where the joints are to be; the process as it is to be.
  JointState at(double time_s) const;
  /// What is switched when, in order, as planned now.
  std::vector<ProcessEvent> events() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lamina
