// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/writer/rapid_passages.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/kinematics/arm/arm_controller.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "lamina/kinematics/model/joint_limits.hpp"
#include "program/backed_off.hpp"
#include "program/external_axes.hpp"
#include "program/rapid/rapid_words.hpp"
#include "program/rapid/writer/rapid_notes.hpp"

namespace lamina {
namespace {

constexpr double kSingularWrist = toRadians(2.0);
constexpr int kJointDecimals = 5;  // deg
constexpr const char* kStation = "STN1";

double rounded(double value, double scale) {
  const double units = std::round(value * scale) / scale;
  return units == 0.0 ? 0.0 : units;  // no -0
}

/// x, y, z [mm], w, x, y, z: as far as a controller resolves them.
std::vector<double> frameOf(const Eigen::Isometry3d& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const Point3 at = pose.translation();
  return {rounded(at.x(), 1e4), rounded(at.y(), 1e4), rounded(at.z(), 1e4), rounded(q.w(), 1e9),
          rounded(q.x(), 1e9),  rounded(q.y(), 1e9),  rounded(q.z(), 1e9)};
}

JointValues startJoints(const KinematicModel& arm, const JointValues& first, double way_mm) {
  if (way_mm == 0.0) return first;
  const auto joints = followingJoints(arm, backedOff(arm.bedFromNozzle(first), way_mm), first);
  const std::optional<std::string> fault = joints ? limitFault(*joints, arm) : "out of reach";
  if (fault)
    throw Unreachable("'" + arm.name() + "' cannot start " + numberText(way_mm) +
                      " mm (rapid.approach_mm) back from the first waypoint along the tool axis: " + *fault);
  return *joints;
}

std::string jointTarget(const KinematicModel& arm, const JointValues& joints, const RapidSettings& settings) {
  const SixJoints six = sixJointsOf(arm, joints);
  std::string text = "[[";
  for (Eigen::Index j = 0; j < six.size(); ++j) {
    if (j > 0) text += ',';
    appendDecimals(text, toDegrees(six[j]), kJointDecimals);
  }
  return text + "]," + rapidExternalAxes(externalAxes(arm, joints), settings) + "]";
}

class PassageWriter {
 public:
  PassageWriter(const RobotMotion& robot, const ProgramStations& stations, const RapidPlan& plan,
                const RapidSettings& settings)
      : arm_(robot.arm), settings_(settings), first_(stations.begin(0)) {
    const std::size_t last = plan.paths.size() - 1;
    last_ = stations.end(last, plan.paths[last].path->motionCount() - 1);
  }

  std::string approach(const std::string& end) const {
    const JointValues joints = startJoints(arm_, first_, settings_.approach_mm);
    return "MoveAbsJ " + jointTarget(arm_, joints, settings_) + "\\NoEOffs" + end;
  }

  std::string retract(const std::string& end) const {
    const Eigen::Isometry3d pose = backedOff(arm_.bedFromNozzle(last_), settings_.approach_mm);
    return "MoveL " + target(pose) + end;
  }

 private:
  std::string target(const Eigen::Isometry3d& pose) const {
    const auto& start = settings_.start_point_mm;
    if (settings_.variant != RapidVariant::Powder5Axes)
      return rapidOffset(pose.translation() - Point3(start[0], start[1], start[2]), settings_);
    const auto joints = followingJoints(arm_, pose, last_);
    if (!joints || limitFault(*joints, arm_))
      throw Unreachable("'" + arm_.name() + "' cannot retract " + numberText(settings_.approach_mm) +
                        " mm (rapid.approach_mm) from the last waypoint along the tool axis: " +
                        (joints ? *limitFault(*joints, arm_) : "out of reach"));
    return rapidPose(pose.translation(), Eigen::Quaterniond(pose.linear())) + "," +
           (settings_.configuration == RapidConfiguration::Fixed
                ? rapidConfiguration(settings_)
                : rapidConfiguration(abbConfiguration(arm_, *joints))) +
           "," + rapidExternalAxes(externalAxes(arm_, *joints), settings_) + "]";
  }

  const KinematicModel& arm_;
  const RapidSettings& settings_;
  JointValues first_;
  JointValues last_;
};

bool isWristSingular(const RobotMotion& robot) {
  return std::any_of(robot.joints.values.begin(), robot.joints.values.end(), [&](const JointValues& values) {
    return std::abs(std::sin(sixJointsOf(robot.arm, values)[4])) < std::sin(kSingularWrist);
  });
}

std::string procedure(std::string_view note, const std::string& name, const std::string& move) {
  return std::string(kRapidNote) + std::string(note) + "\n  PROC " + name + "()\n    " + move +
         "\n  ENDPROC\n";
}

}  // namespace

RapidSettings withArmCell(RapidSettings settings, const KinematicModel& arm) {
  requireControllerKind(arm.urdf(), "abb", "RAPID");
  if (!settings.declares_cell) return settings;
  const ArmCell cell = armCell(arm);
  if (settings.tool_frame.empty()) settings.tool_frame = frameOf(cell.flange_from_nozzle);
  if (settings.work_object_frame.empty()) settings.work_object_frame = frameOf(cell.carrier_from_bed);
  if (settings.positioner.empty() && cell.is_bed_carried) settings.positioner = kStation;
  if (settings.tool_mass_kg == 0.0 && cell.load) {
    settings.tool_mass_kg = cell.load->mass_kg;
    const Point3& centre = cell.load->centre_mm;
    settings.tool_centre_of_gravity_mm = {rounded(centre.x(), 1e4), rounded(centre.y(), 1e4),
                                          rounded(centre.z(), 1e4)};
  }
  return settings;
}

RapidPassages rapidPassages(const RobotMotion& robot, const ProgramStations& stations, const RapidPlan& plan,
                            const std::string& air_speed, const RapidSettings& settings) {
  const PassageWriter writer(robot, stations, plan, settings);
  const std::string end =
      "," + air_speed + ",fine," + settings.tool + "\\WObj:=" + settings.work_object + ";";
  RapidPassages passages;
  const std::string start_name = settings.procedure + "_start";
  const std::string end_name = settings.procedure + "_end";
  passages.procedures = procedure(kRapidApproach, start_name, writer.approach(end));
  passages.to_part = "    " + start_name + ";\n";
  if (settings.approach_mm > 0.0) {
    passages.procedures += procedure(kRapidRetract, end_name, writer.retract(end));
    passages.from_part = "    " + end_name + ";\n";
  }
  passages.is_wrist_singular = isWristSingular(robot);
  return passages;
}

}  // namespace lamina
