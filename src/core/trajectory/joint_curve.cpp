// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/joint_curve.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/angle.hpp"
#include "trajectory/smooth_rise.hpp"

namespace lamina {
namespace {

constexpr double kStraight = 1e-9;         // turns below this are none [mm per mm, rad]
constexpr double kDeviation = 3.0 / 16.0;  // of half a blend, per turn

}  // namespace

JointCurve::JointCurve(JointStations stations, const KinematicModel& model,
                       const TrajectorySettings& settings)
    : stations_(std::move(stations)), settings_(settings) {
  const auto joints = static_cast<Eigen::Index>(model.joints().size());
  max_speed_.resize(joints);
  for (Eigen::Index j = 0; j < joints; ++j) max_speed_[j] = model.joints()[j].max_speed;
  max_acceleration_ = max_speed_ / settings.joint_ramp_s;
  const std::size_t count = stations_.each.size();
  length_.reserve(count);
  for (std::size_t i = 1; i < count; ++i) {
    const JointStation& end = stations_.each[i];
    const JointValues way = end.values - stations_.each[i - 1].values;
    length_.push_back(end.length_mm > 0.0 ? end.length_mm
                                          : way.cwiseQuotient(max_speed_).cwiseAbs().maxCoeff());
  }
  blend_.assign(count, 0.0);
  tip_turn_.assign(count, 0.0);
  tool_axis_turn_.assign(count, 0.0);
  is_rest_.assign(count, true);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    measureTurn(i, model);
    is_rest_[i] = restsAt(i);
    if (!is_rest_[i]) blend_[i] = roundedBy(i);
  }
}

void JointCurve::measureTurn(std::size_t station, const KinematicModel& model) {
  const JointStation& here = stations_.each[station];
  const Eigen::Matrix<double, 6, 1> turned = model.jacobian(here.values) * turn(station);
  tip_turn_[station] = turned.head<3>().norm();
  tool_axis_turn_[station] = turned.tail<3>().cross(here.pose.linear().col(2)).norm();
}

bool JointCurve::restsAt(std::size_t station) const {
  const JointStation& before = stations_.each[station];
  const JointStation& after = stations_.each[station + 1];
  if (before.dwell_s > 0.0) return true;
  if ((before.length_mm > 0.0) != (after.length_mm > 0.0)) return true;
  if ((before.area_mm2 > 0.0) != (after.area_mm2 > 0.0)) return true;
  return (tipTolerance(station) == 0.0 && tip_turn_[station] > kStraight) ||
         (toolAxisTolerance(station) == 0.0 && tool_axis_turn_[station] > kStraight);
}

double JointCurve::roundedBy(std::size_t station) const {
  double half = 0.5 * std::min(length_[station - 1], length_[station]);
  if (tip_turn_[station] > kStraight)
    half = std::min(half, tipTolerance(station) / (kDeviation * tip_turn_[station]));
  if (tool_axis_turn_[station] > kStraight)
    half = std::min(half, toolAxisTolerance(station) / (kDeviation * tool_axis_turn_[station]));
  return half;
}

// Half of each tolerance is left to the averaging that limits jerk; half of that on lines is used up by
// stations that lie on them.
double JointCurve::tipTolerance(std::size_t station) const {
  const double share = settings_.jerk_ramp_s > 0.0 ? 0.5 : 1.0;
  const double line_mm = stations_.each[station].is_smooth ? 0.5 * settings_.line_tolerance_mm : 0.0;
  return share * std::max(line_mm, settings_.blend_tolerance_mm);
}

double JointCurve::toolAxisTolerance(std::size_t station) const {
  const double share = settings_.jerk_ramp_s > 0.0 ? 0.5 : 1.0;
  const double line_deg = stations_.each[station].is_smooth ? 0.5 * settings_.line_tolerance_deg : 0.0;
  return toRadians(share * std::max(line_deg, settings_.blend_tolerance_deg));
}

JointValues JointCurve::tangent(std::size_t span) const {
  return (stations_.each[span + 1].values - stations_.each[span].values) / length_[span];
}

CurvePoint JointCurve::at(std::size_t span, double along) const {
  const double b_start = blend_[span];
  const double b_end = blend_[span + 1];
  const double left = length_[span] - along;
  const bool is_in_start = along < b_start;
  if (!is_in_start && left >= b_end)
    return {stations_.each[span].values + along * tangent(span), tangent(span),
            JointValues::Zero(max_speed_.size())};
  const std::size_t corner = is_in_start ? span : span + 1;
  const double b = is_in_start ? b_start : b_end;
  const double u = std::clamp(is_in_start ? 0.5 + 0.5 * along / b : 0.5 - 0.5 * left / b, 0.0, 1.0);
  const JointValues before = tangent(corner - 1);
  const JointValues turned = turn(corner);
  return {stations_.each[corner].values + b * ((2.0 * u - 1.0) * before + 2.0 * smoothRiseSum(u) * turned),
          before + smoothRise(u) * turned, smoothRiseRate(u) / (2.0 * b) * turned};
}

JointValues JointCurve::positionAt(std::size_t span, double along) const { return at(span, along).position; }

}  // namespace lamina
