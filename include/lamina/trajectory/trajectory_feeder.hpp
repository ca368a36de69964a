// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/toolpath/job_override.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "lamina/trajectory/trajectory_feeder_settings.hpp"

namespace lamina {

/// Consecutive points of a trajectory, with times since the start of the job. The first point lies on the
/// motion that was handed over before. The points replace those of the controller from the time of the first
/// one on.
struct TrajectoryChunk {
  std::vector<JointState> points;
};

/// State of a `TrajectoryFeeder`.
enum class TrajectoryFeederState : std::uint8_t {
  Running,
  Paused,    ///< braking to rest or at rest, until it is resumed
  Aborted,   ///< braking to rest or at rest for good, or lifting the tool
  Finished,  ///< the last point has been handed over
};

class SpeedPlan;

/// Length and volume of beads.
struct LaidAmount {
  double length_mm = 0.0;
  double volume_mm3 = 0.0;
};

/// The reason why a share of the planned speeds is refused; empty for shares from 0.01 to `feeder.feed_most`.
std::string speedRefusal(double share, const TrajectoryFeederSettings& settings);

/// A change to a share of the planned speeds, with the plan for it.
struct SpeedChange {
  double share = 1.0;
  double reached = 1.0;  ///< share of the planned speeds that is reached within the limits, on average
  std::shared_ptr<const SpeedPlan> plan;  ///< null for a share of at most 1
};

/// How the tool is lifted from the part after an abort.
struct ToolLift {
  double height_mm = 0.0;   ///< against the tool axis; positive
  double speed_mm_s = 0.0;  ///< positive
};

/// Hands a trajectory to a controller in chunks. All times are of one clock that was 0 at the start of the
/// job. A pause brakes along the path, as hard as the limits allow, and comes to rest on it; resuming
/// continues from there, so that nothing is left out or deposited twice. The process is switched off (flow,
/// laser, wire, powder and gas) when the motion rests after a pause, and at once after an abort.
class TrajectoryFeeder {
 public:
  /// @param from_mm  length of beads [mm] that is left out with all that comes before it: the motion begins
  /// at
  ///   rest where the bead goes on, or where the next one begins, and its process with the waits and leads of
  ///   a start; 0 for all of it
  /// @throws InvalidConfig naming key, value and bound; InvalidInput if nothing is laid after that length
  TrajectoryFeeder(const TimedPath& path, const TrajectoryFeederSettings& settings, double from_mm = 0.0);
  ~TrajectoryFeeder();
  TrajectoryFeeder(TrajectoryFeeder&&) noexcept;
  TrajectoryFeeder& operator=(TrajectoryFeeder&&) noexcept;

  /// The next chunk, if the controller has less motion left than `feeder.ahead_s` and one chunk; nothing if
  /// it has enough, or there is no more. To be called until it returns nothing, at least once per duration of
  /// a chunk.
  std::optional<TrajectoryChunk> next(double now_s);

  /// Brakes to rest. Without effect unless running, or if the motion ends within the reaction time. A motion
  /// that is held at a layer stays held.
  void pause(double now_s);
  /// Continues after a pause; powder and gas settle first. A motion that was paused while it was held at a
  /// layer is held there again. Without effect unless paused.
  void resume(double now_s);
  /// Computes a change of speed for `setSpeed`. Takes linear time for a share above 1, else none. May be
  /// called while other threads use the feeder.
  /// @throws InvalidInput as `speedRefusal`
  SpeedChange speedChange(double share) const;
  /// Continues on the same path at a share of the planned speeds, from the first point that can still change.
  /// The motion first brakes or speeds up as hard as the limits allow. For a share below 1 all speeds are
  /// then scaled by it, so that no limit of a joint is exceeded. For a share above 1 the feeds are scaled,
  /// and reached where the limits of joints, path and roundings allow it. Rests keep their duration. While
  /// paused or at rest, a change takes effect on resuming. A hold at a layer remains. The flow is scaled with
  /// the speed.
  void setSpeed(const SpeedChange& change, double now_s);
  /// As above. Takes linear time, which `clock` measures.
  /// @param now_s  may be later than now, for the change to be handed over in time
  /// @return false, without effect, if less than half of the reaction time is left when it is computed
  bool setSpeed(const SpeedChange& change, double now_s, const std::function<double()>& clock);
  /// Computes a change of speed and makes it.
  /// @param share  of the planned speeds; 1 at the start of the job
  /// @throws InvalidInput as `speedRefusal`; nothing changes
  void setSpeed(double share, double now_s);
  /// Sets the share of the planned material (flow, wire, screw, powder), or of the planned laser power, from
  /// the first point that can still change. The transition takes `feeder.override_ramp_s` times the change of
  /// the share. The motion remains the same.
  /// @throws InvalidInput if `kind` is Feed, the share is outside `boundsOf`, or `kind` is Power and the
  ///   toolpath states none; nothing changes
  void setShare(OverrideKind kind, double share, double now_s);
  /// Holds the motion at the beginning of a layer until `release`: at the end of what comes before the layer,
  /// or on the travel with which it begins. The motion up to there remains the same. A pause that comes to
  /// rest before the layer cancels the hold.
  /// @return false, without effect, if the feeder is not running or already holds, has no such layer, cannot
  ///   stop in time, or would have to stop on the layer's first bead, because that joins what comes before
  bool holdAtLayer(std::size_t layer, double now_s);
  /// Continues into the layer; powder and gas settle first. Without effect unless running and held.
  void release(double now_s);
  /// Whether a hold at a layer is planned or reached, paused or not.
  bool isHeld() const;
  /// Brakes to rest for good. Without effect after the end of the motion or an abort.
  void abort(double now_s);
  /// Brakes to rest for good, and then lifts the tool.
  /// @throws InvalidInput if height or speed of the lift is not positive, Unreachable if a joint would leave
  ///   its limits on the lift; the motion is aborted nevertheless, without the lift
  void abort(double now_s, const ToolLift& lift, const KinematicModel& model);

  TrajectoryFeederState state() const;
  /// Time at which the motion comes to rest, as planned now [s].
  double restTime() const;
  /// Planned state of joints and process at a time.
  JointState at(double time_s) const;
  /// What of the path's beads is laid at a time, as planned, from the start of the path.
  LaidAmount laidAt(double time_s) const;
  /// The switching of the process, in order of time, as planned now.
  std::vector<ProcessEvent> events() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lamina
