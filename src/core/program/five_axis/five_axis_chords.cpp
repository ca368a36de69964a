// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/five_axis/five_axis_chords.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostPieces = 1000;
constexpr double kMostStep = M_PI / 2.0;  // rad, of a rotary joint from one line to the next
constexpr double kTurn = 2.0 * M_PI;
constexpr int kPlaces = 8;  // parts of a piece between which the tip is looked at

double rotaryWay(const KinematicModel& machine, const JointValues& from, const JointValues& to) {
  double most = 0.0;
  for (std::size_t j = 0; j < machine.joints().size(); ++j) {
    const auto joint = static_cast<Eigen::Index>(j);
    if (machine.joints()[j].kind == JointKind::Rotary)
      most = std::max(most, std::abs(to[joint] - from[joint]));
  }
  return most;
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

/// The straight way of the tip and the steady turn of the nozzle between two stations.
class Chord {
 public:
  Chord(const KinematicModel& machine, const JointValues& begin, const JointValues& end)
      : machine_(machine), from_(machine.bedFromNozzle(begin)), to_(machine.bedFromNozzle(end)) {}

  Point3 tip(double share) const { return (1.0 - share) * from_.translation() + share * to_.translation(); }

  JointValues joints(double share, const JointValues& near) const {
    Eigen::Isometry3d pose(Eigen::Quaterniond(from_.linear()).slerp(share, Eigen::Quaterniond(to_.linear())));
    pose.translation() = tip(share);
    return nearest(machine_, pose, near);
  }

  /// How far the tip leaves the even way along the line while the joints move evenly.
  double error(const JointsBetween& begin, const JointsBetween& end) const {
    double most = 0.0;
    for (int place = 1; place < kPlaces; ++place) {
      const double part = static_cast<double>(place) / kPlaces;
      const JointValues values = (1.0 - part) * begin.values + part * end.values;
      const double share = (1.0 - part) * begin.share + part * end.share;
      most = std::max(most, (machine_.bedFromNozzle(values).translation() - tip(share)).norm());
    }
    return most;
  }

 private:
  const KinematicModel& machine_;
  Eigen::Isometry3d from_;
  Eigen::Isometry3d to_;
};

}  // namespace

std::vector<JointsBetween> jointsBetween(const KinematicModel& machine, const JointValues& begin,
                                         const JointValues& end, double tolerance_mm) {
  if (rotaryWay(machine, begin, end) > M_PI) return {};
  const Chord chord(machine, begin, end);
  std::vector<JointsBetween> between;
  std::vector<JointsBetween> ahead = {{1.0, end}};  // the next one last
  JointsBetween last{0.0, begin};
  while (!ahead.empty()) {
    if (!(chord.error(last, ahead.back()) > tolerance_mm)) {
      if (rotaryWay(machine, last.values, ahead.back().values) > kMostStep && !between.empty())
        throw Unreachable("'" + machine.name() + "' comes to it with other joints than those given");
      last = ahead.back();
      if (last.share < 1.0) between.push_back(last);
      ahead.pop_back();
      continue;
    }
    const double share = 0.5 * (last.share + ahead.back().share);
    const JointValues values = chord.joints(share, last.values);
    if (values.size() == 0)
      throw Unreachable("'" + machine.name() + "' has no joints on the straight line to it");
    ahead.push_back({share, values});
    if (between.size() + ahead.size() > kMostPieces || ahead.size() > 40)
      throw Unreachable("'" + machine.name() + "' has no joints on the straight line to it that follow " +
                        "steadily: the tip leaves it by more than " + numberText(tolerance_mm) +
                        " mm however it is divided");
  }
  return between;
}

}  // namespace lamina
