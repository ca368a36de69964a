// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/program_stations.hpp"

#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/kinematics/model/joint_limits.hpp"

namespace lamina {
namespace {

constexpr double kSameTip = 1e-3;       // mm: below what machines hold, above what solvers leave
constexpr double kSameToolAxis = 1e-4;  // rad

[[noreturn]] void refuseFaults(const JointPath& joints, const KinematicModel& model) {
  const FaultyWaypoint& first = joints.faults.front();
  throw Unreachable("'" + model.name() + "' cannot run " + std::to_string(joints.faults.size()) +
                    " waypoint(s); the first is " + toText(first.at) + ": " + toString(first.fault) +
                    (first.reason.empty() ? "" : ", " + first.reason));
}

void requireSameWaypoint(const WaypointIndex& given, const WaypointIndex& expected) {
  if (given != expected)
    throw InvalidInput("the joints at " + toText(given) + " stand where those at " + toText(expected) +
                       " are expected; they are of another toolpath");
}

void requireWithinLimits(const JointValues& values, const KinematicModel& model, const WaypointIndex& at) {
  if (const auto fault = limitFault(values, model))
    throw Unreachable(toText(at) + ", '" + model.name() + "': " + *fault);
}

/// @param tolerance  of the tool axis [rad]
void requireSamePose(const Eigen::Isometry3d& given, const Eigen::Isometry3d& expected, double tolerance,
                     const WaypointIndex& at) {
  const double off_mm = (given.translation() - expected.translation()).norm();
  const Point3 tool_axis = given.linear().col(2);
  const Point3 wanted = expected.linear().col(2);
  const double turn = angleBetween(tool_axis, wanted);
  if (!(off_mm <= kSameTip && turn <= kSameToolAxis + tolerance))
    throw InvalidInput(toText(at) + ": the joints bring the nozzle " + numberText(off_mm) + " mm and " +
                       numberText(turn * kDegreesPerRadian) +
                       " deg off the waypoint; expected those of this toolpath where it stands");
}

}  // namespace

ProgramStations::ProgramStations(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                                 const KinematicModel& model, const JointPath& joints)
    : joints_(joints) {
  if (!joints.isRunnable()) refuseFaults(joints, model);
  if (joints.values.size() != joints.at.size())
    throw InvalidInput("the joint path has " + std::to_string(joints.at.size()) + " waypoints and " +
                       std::to_string(joints.values.size()) + " values; must be as many");
  std::size_t station = 0;
  const auto check = [&](const Path& path, const WaypointIndex& expected) {
    if (station >= joints.at.size())
      throw InvalidInput("the joint path ends before " + toText(expected) + "; it is of another toolpath");
    requireSameWaypoint(joints.at[station], expected);
    const JointValues& values = joints.values[station++];
    if (values.size() != static_cast<Eigen::Index>(model.joints().size()))
      throw InvalidInput(toText(expected) + ": there are values of " + std::to_string(values.size()) +
                         " joints; '" + model.name() + "' has " + std::to_string(model.joints().size()));
    requireWithinLimits(values, model, expected);
    Eigen::Isometry3d part_from_nozzle(path.orientation.at(expected.waypoint));
    part_from_nozzle.translation() = path.points[expected.waypoint];
    requireSamePose(model.bedFromNozzle(values), bed_from_part * part_from_nozzle, joints.tool_axis_tolerance,
                    expected);
  };
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& path = toolpath.layers[l].paths[p];
      first_.push_back(station);
      check(path, {l, p, 0});
      for (std::size_t m = 0; m < path.motionCount(); ++m) check(path, {l, p, path.motionEnd(m)});
    }
  if (station != joints.at.size())
    throw InvalidInput("the joint path goes on after the toolpath, at " + toText(joints.at[station]) +
                       "; it is of another toolpath");
}

}  // namespace lamina
