// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "kinematics/joint_path/station_joints.hpp"
#include "kinematics/joint_path/taut_string.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {

namespace {

constexpr double kAlong = 1e-9;  // sine: of a tool axis along an axis
constexpr double kSlack = 1e-9;  // rad, of the tolerance

/// The joints of a machine of five axes whose tool axis is along the axis of one rotary joint while the other
/// is at zero.
struct SwingJoints {
  Eigen::Index swinging = 0;
  Eigen::Index tilting = 0;
  std::array<Eigen::Index, 3> linear{};
};

std::optional<SwingJoints> swingJoints(const KinematicModel& model, const std::vector<JointRange>& ranges) {
  std::vector<Eigen::Index> linear;
  std::vector<Eigen::Index> rotary;
  for (std::size_t j = 0; j < ranges.size(); ++j)
    (ranges[j].is_rotary ? rotary : linear).push_back(static_cast<Eigen::Index>(j));
  if (model.toolAxisSpin() == ToolAxisSpin::Given || linear.size() != 3 || rotary.size() != 2)
    return std::nullopt;
  const JointValues zero = JointValues::Zero(static_cast<Eigen::Index>(ranges.size()));
  const Point3 tool_axis = model.bedFromNozzle(zero).linear().col(2);
  const Jacobian jacobian = model.jacobian(zero);
  for (std::size_t i = 0; i < 2; ++i) {
    const Point3 axis = jacobian.col(rotary[i]).tail<3>();
    const JointRange& range = ranges[static_cast<std::size_t>(rotary[i])];
    if (axis.cross(tool_axis).norm() < kAlong && range.winds)
      return SwingJoints{rotary[i], rotary[1 - i], {linear[0], linear[1], linear[2]}};
  }
  return std::nullopt;
}

class SwingSteadying {
 public:
  SwingSteadying(const StationTask& task, const SwingJoints& joints)
      : task_(task), joints_(joints), tolerance_(toRadians(task.settings.swing_tolerance_deg)) {}

  void steady(std::vector<StationJoints>& stations, std::size_t begin, std::size_t end) const {
    const std::vector<Gate> gates = gatesOf(stations, begin, end);
    const std::vector<double> swings = tautString(gates);
    std::vector<JointValues> steadied(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      const auto values = swungTo(stations[i].values, swings[i - begin], task_.stations[i]);
      if (!values) return;
      steadied[i - begin] = *values;
    }
    for (std::size_t i = begin; i < end; ++i) stations[i].values = steadied[i - begin];
  }

 private:
  static Point3 toolAxisOf(const Station& station) { return station.orientation * Point3::UnitZ(); }

  /// By how much the joint may swing off the azimuth of the tool axis; infinite if it may stand anywhere.
  double room(const JointValues& values, const Station& station) const {
    const Point3 axis = task_.model.jacobian(values).col(joints_.swinging).tail<3>().normalized();
    const double sine = axis.cross(toolAxisOf(station)).norm();
    if (sine <= std::sin(tolerance_)) return std::numeric_limits<double>::infinity();
    return std::asin(std::sin(tolerance_) / sine);
  }

  /// Whether the other joint can tilt as far the other way, so that half a turn of the swing changes nothing.
  bool tiltsBothWays(const std::vector<StationJoints>& stations, std::size_t begin, std::size_t end) const {
    const JointRange& range = task_.solver.ranges()[static_cast<std::size_t>(joints_.tilting)];
    return std::all_of(stations.begin() + static_cast<std::ptrdiff_t>(begin),
                       stations.begin() + static_cast<std::ptrdiff_t>(end), [&](const StationJoints& here) {
                         const double tilt = std::abs(here.values[joints_.tilting]) + tolerance_;
                         return -tilt >= range.low && tilt <= range.high;
                       });
  }

  std::vector<Gate> gatesOf(const std::vector<StationJoints>& stations, std::size_t begin,
                            std::size_t end) const {
    const double period = tiltsBothWays(stations, begin, end) ? M_PI : 2.0 * M_PI;
    std::vector<Gate> gates;
    gates.reserve(end - begin);
    double at = 0.0;
    double middle = stations[begin].values[joints_.swinging];
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin) at += task_.stations[i].motion.duration_s;
      const JointValues& values = stations[i].values;
      double half = room(values, task_.stations[i]);
      if (i == begin || i + 1 == end) half = 0.0;
      if (std::isfinite(half)) middle += std::remainder(values[joints_.swinging] - middle, period);
      gates.push_back({at, middle - half, middle + half});
    }
    return gates;
  }

  /// The tool axis as near to the station's as the other joint brings it, and the tip there.
  std::optional<JointValues> swungTo(JointValues values, double swing, const Station& station) const {
    const KinematicModel& model = task_.model;
    const auto& ranges = task_.solver.ranges();
    values[joints_.swinging] = nearMiddle(ranges[static_cast<std::size_t>(joints_.swinging)], swing);
    const Point3 asked = toolAxisOf(station);
    Jacobian jacobian = model.jacobian(values);
    const Point3 axis = jacobian.col(joints_.tilting).tail<3>().normalized();
    const Point3 tool_axis = model.bedFromNozzle(values).linear().col(2);
    values[joints_.tilting] += std::atan2(axis.dot(tool_axis.cross(asked)),
                                          tool_axis.dot(asked) - axis.dot(tool_axis) * axis.dot(asked));
    // The tip goes straight with the linear joints.
    jacobian = model.jacobian(values);
    Eigen::Matrix3d rates;
    for (std::size_t j = 0; j < 3; ++j)
      rates.col(static_cast<Eigen::Index>(j)) = jacobian.col(joints_.linear[j]).head<3>();
    const Point3 way = rates.inverse() * (station.position - model.bedFromNozzle(values).translation());
    for (std::size_t j = 0; j < 3; ++j) values[joints_.linear[j]] += way[static_cast<Eigen::Index>(j)];
    const Point3 own = model.bedFromNozzle(values).linear().col(2);
    const double off = std::atan2(own.cross(asked).norm(), own.dot(asked));
    if (off > tolerance_ + kSlack || !task_.solver.isAllowed(values)) return std::nullopt;
    return values;
  }

  const StationTask& task_;
  SwingJoints joints_;
  double tolerance_;
};

}  // namespace

void steadySwings(std::vector<StationJoints>& stations, const StationTask& task) {
  const auto joints = swingJoints(task.model, task.solver.ranges());
  if (!joints || !(task.settings.swing_tolerance_deg > 0.0)) return;
  const SwingSteadying steadying(task, *joints);
  for (std::size_t begin = 0; begin < stations.size();) {
    std::size_t end = begin + 1;
    if (stations[begin].node != kNoNode) {
      while (end < stations.size() && stations[end].is_linked) ++end;
      steadying.steady(stations, begin, end);
    }
    begin = end;
  }
}

}  // namespace lamina
