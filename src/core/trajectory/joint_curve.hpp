// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "trajectory/joint_stations.hpp"

namespace lamina {

/// Joint values at a point of a curve, with their derivatives by its parameter.
struct CurvePoint {
  JointValues position;
  JointValues tangent;  ///< first derivative
  JointValues bend;     ///< second derivative
};

/// A smooth curve of the joints: straight between stations, rounded at them.
///
/// The parameter is the length of the tip's path [mm]; where the tip turns in place, it is the time that the
/// joints need at their greatest speeds [s]. Span i ends at station i + 1. Within `blend(i)` of station i the
/// tangent changes from that of one span to that of the next as 3 u² - 2 u³. So the second derivative is
/// continuous, and the curve passes the station at a distance of 3/16 of the difference of the tangents times
/// `blend(i)`.
class JointCurve {
 public:
  JointCurve(JointStations stations, const KinematicModel& model, const TrajectorySettings& settings);

  std::size_t spanCount() const { return length_.size(); }
  const JointStation& spanEnd(std::size_t span) const { return stations_.each[span + 1]; }
  /// For each station of the joint path, the index of its station on the curve.
  const std::vector<std::size_t>& ofPath() const { return stations_.of_path; }
  const std::vector<WaypointIndex>& looseTravels() const { return stations_.loose; }
  double length(std::size_t span) const { return length_[span]; }
  double blend(std::size_t station) const { return blend_[station]; }
  /// Whether the motion stops at a station: at both ends, where beads begin and end or the nozzle waits, and
  /// at corners that are not rounded.
  bool isRest(std::size_t station) const { return is_rest_[station]; }
  /// Time for which the toolpath lets the nozzle wait at a station [s].
  double dwell(std::size_t station) const { return stations_.each[station].dwell_s; }

  /// @param along  from the start of the span, 0 to its length
  CurvePoint at(std::size_t span, double along) const;
  JointValues positionAt(std::size_t span, double along) const;
  JointValues tangent(std::size_t span) const;
  /// Tangent of the span after a station less that of the span before it.
  JointValues turn(std::size_t station) const { return tangent(station) - tangent(station - 1); }
  /// Change of direction of the tip [mm per unit of the parameter] and of the tool axis [rad] at a station.
  double tipTurn(std::size_t station) const { return tip_turn_[station]; }
  double toolAxisTurn(std::size_t station) const { return tool_axis_turn_[station]; }
  /// Tolerance of the tip and of the tool axis at a station [mm, rad]; infinite if none is asked for.
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
