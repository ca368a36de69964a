// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/five_axis/joint_chords.hpp"

#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostPieces = 1000;
constexpr double kTurn = 2.0 * M_PI;

bool isWoundBack(const KinematicModel& machine, const JointValues& begin, const JointValues& end) {
  for (std::size_t j = 0; j < machine.joints().size(); ++j) {
    const auto joint = static_cast<Eigen::Index>(j);
    if (machine.joints()[j].kind == JointKind::Rotary && std::abs(end[joint] - begin[joint]) > M_PI)
      return true;
  }
  return false;
}

/// How far the tip is from the middle of its line halfway between the joints.
double chordError(const KinematicModel& machine, const JointValues& begin, const JointValues& end) {
  const Point3 halfway = machine.bedFromNozzle(0.5 * (begin + end)).translation();
  const Point3 middle =
      0.5 * (machine.bedFromNozzle(begin).translation() + machine.bedFromNozzle(end).translation());
  return (halfway - middle).norm();
}

/// The values with rotary joints turned by whole turns to be next to others.
JointValues wound(JointValues values, const KinematicModel& machine, const JointValues& near) {
  for (std::size_t j = 0; j < machine.joints().size(); ++j) {
    const auto joint = static_cast<Eigen::Index>(j);
    if (machine.joints()[j].kind == JointKind::Rotary)
      values[joint] += kTurn * std::round((near[joint] - values[joint]) / kTurn);
  }
  return values;
}

double rotaryWay(const KinematicModel& machine, const JointValues& from, const JointValues& to) {
  double most = 0.0;
  for (std::size_t j = 0; j < machine.joints().size(); ++j) {
    const auto joint = static_cast<Eigen::Index>(j);
    if (machine.joints()[j].kind == JointKind::Rotary)
      most = std::max(most, std::abs(to[joint] - from[joint]));
  }
  return most;
}

JointValues nearest(const KinematicModel& machine, const Eigen::Isometry3d& pose, const JointValues& near) {
  JointValues best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& solution : machine.solutions(pose, near)) {
    const JointValues values = wound(solution.values, machine, near);
    const double way = rotaryWay(machine, near, values);
    if (way < least) least = way, best = values;
  }
  return best;
}

}  // namespace

std::vector<JointValues> jointsBetween(const KinematicModel& machine, const JointValues& begin,
                                       const JointValues& end, double tolerance_mm) {
  const double error = chordError(machine, begin, end);
  if (!(error > tolerance_mm) || isWoundBack(machine, begin, end)) return {};
  const double wanted = std::ceil(std::sqrt(error / tolerance_mm));
  const auto pieces = static_cast<std::size_t>(std::min(wanted, double{kMostPieces}));
  const Eigen::Isometry3d from = machine.bedFromNozzle(begin);
  const Eigen::Isometry3d to = machine.bedFromNozzle(end);
  const Eigen::Quaterniond from_turn(from.linear());
  const Eigen::Quaterniond to_turn(to.linear());
  std::vector<JointValues> between;
  JointValues last = begin;
  const double most_step = M_PI / 4.0 + kTurn / static_cast<double>(pieces);
  for (std::size_t i = 1; i < pieces; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(pieces);
    Eigen::Isometry3d pose(from_turn.slerp(share, to_turn));
    pose.translation() = (1.0 - share) * from.translation() + share * to.translation();
    const JointValues values = nearest(machine, pose, last);
    if (values.size() == 0 || rotaryWay(machine, last, values) > most_step)
      throw Unreachable("'" + machine.name() +
                        "' has no joints on the straight line to it that follow steadily");
    between.push_back(values);
    last = values;
  }
  if (rotaryWay(machine, last, end) > most_step)
    throw Unreachable("'" + machine.name() + "' comes to it with other joints than those given");
  return between;
}

}  // namespace lamina
