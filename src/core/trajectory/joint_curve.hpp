// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "trajectory/joint_stations.hpp"

namespace lamina {

/// Joint values on a curve and how they change with its parameter.
struct CurvePoint {
  JointValues position;
  JointValues tangent;  ///< first derivative
  JointValues bend;     ///< second derivative
};

/// A smooth way of the joints: straight from station to station, rounded at them.
///
/// The parameter is the way of the tip along the toolpath [mm]; where the tip turns in place it is the time
/// that the joints need at their greatest speeds [s]. Span i ends at station i + 1. Within `blend(i)` of
/// station i the tangent goes over from that of one span to that of the next as 3 u² - 2 u³, which makes the
/// second derivative continuous and leaves the station by 3/16 of the tangents' difference times
/// `blend(i)`.
class JointCurve {
 public:
  JointCurve(JointStations stations, const KinematicModel& model, const TrajectorySettings& settings);

  std::size_t spanCount() const { return length_.size(); }
  const JointStation& spanEnd(std::size_t span) const { return stations_.each[span + 1]; }
  /// Index among the stations of the curve, of a station of the joint path.
  const std::vector<std::size_t>& ofPath() const { return stations_.of_path; }
  const std::vector<WaypointIndex>& looseTravels() const { return stations_.loose; }
  double length(std::size_t span) const { return length_[span]; }
  double blend(std::size_t station) const { return blend_[station]; }
  /// Where it rests: at both ends, where beads begin and end or the nozzle waits, at corners that are not
  /// rounded.
  bool isRest(std::size_t station) const { return is_rest_[station]; }
  /// How long the toolpath asks the nozzle to wait at a station [s].
  double dwell(std::size_t station) const { return stations_.each[station].dwell_s; }

  /// @param along  from the start of the span, 0 to its length
  CurvePoint at(std::size_t span, double along) const;
  JointValues positionAt(std::size_t span, double along) const;
  JointValues tangent(std::size_t span) const;
  /// tangent of the span after a station less that before it
  JointValues turn(std::size_t station) const { return tangent(station) - tangent(station - 1); }
  /// What the turn does to the tip [mm per parameter] and to the tool axis [rad].
  double tipTurn(std::size_t station) const { return tip_turn_[station]; }
  double toolAxisTurn(std::size_t station) const { return tool_axis_turn_[station]; }
  /// Of tip and tool axis, at a station [mm, rad]; infinite where no tolerance is asked.
  double tipTolerance(std::size_t station) const;
  double toolAxisTolerance(std::size_t station) const;

  const JointValues& maxSpeed() const { return max_speed_; }
  const JointValues& maxAcceleration() const { return max_acceleration_; }

 private:
  void measureTurn(std::size_t station, const KinematicModel& model);
  bool restsAt(std::size_t station) const;
  double roundedBy(std::size_t station) const;

  JointStations stations_;
  TrajectorySettings settings_;
  std::vector<double> length_;
  std::vector<double> blend_;
  std::vector<double> tip_turn_;
  std::vector<double> tool_axis_turn_;
  std::vector<bool> is_rest_;
  JointValues max_speed_;
  JointValues max_acceleration_;
};

}  // namespace lamina
