// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/robot_report.hpp"

#include <Eigen/Geometry>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/kinematics/description_files/inverse_trial.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/verification/collision/checked_bodies.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

struct RobotArguments {
  std::string path;
  std::string written;
  int poses = 0;
};

/// Summary of a description, with links that are built into each other, which take FCL to be found.
struct Reported {
  RobotReport report;
  std::vector<std::pair<std::string, std::string>> built_in;
  InverseTrial inverse;
};

Reported reportedRobot(const std::string& urdf, int poses) {
  RobotReport report = robotReport(urdf);
  const auto model = kinematicModelFromUrdf(withBedAndNozzle(urdf));
  return {std::move(report), builtInLinks(*model, linkBodies(model->urdf())),
          tryInverse(*model, static_cast<std::size_t>(poses))};
}

/// As people read it: degrees for what turns.
double shownValue(const DrivenJoint& joint, double value) {
  return joint.kind == JointKind::Linear ? value : toDegrees(value);
}

void printTrial(const InverseTrial& trial) {
  std::printf("inverse    %zu of %zu poses reached, %zu with the joints they were made by; %s\n",
              trial.reached, trial.poses, trial.recovered,
              trial.ends ? "none beyond any reach" : "one beyond any reach has a solution");
  std::printf(
      "inverse    %zu of %zu poses off singularities with the joints they were made by; all within %.1e mm "
      "and %.1e rad\n",
      trial.regular_recovered, trial.regular, trial.tip_error_mm, trial.turn_error_rad);
}

void printRobot(const Reported& robot) {
  const RobotReport& report = robot.report;
  const Eigen::Isometry3d& zero = report.base_from_flange_at_zero;
  const Eigen::Quaterniond turn(zero.linear());
  std::printf("robot      %s\n", report.name.c_str());
  std::printf("class      %s\n", report.kinematic_class.c_str());
  if (!report.redundancy.empty()) std::printf("redundancy %s\n", report.redundancy.c_str());
  std::printf("flange     %s\n", report.flange.c_str());
  std::printf("at zero    (%.3f, %.3f, %.3f) mm, quaternion (%.6f, %.6f, %.6f, %.6f)\n",
              zero.translation().x(), zero.translation().y(), zero.translation().z(), turn.w(), turn.x(),
              turn.y(), turn.z());
  std::printf("reach      %.0f mm from axis 1\n", report.reach_mm);
  for (const DrivenJoint& joint : report.joints) {
    const char* unit = joint.kind == JointKind::Linear ? "mm" : "deg";
    std::printf("joint      %s: %.6g to %.6g %s, %.6g %s/s\n", joint.name.c_str(),
                shownValue(joint, joint.low), shownValue(joint, joint.high), unit,
                shownValue(joint, joint.max_speed), unit);
  }
  for (const ReportedBody& body : report.bodies)
    body.triangles > 0
        ? std::printf("body       %s: mesh of %zu triangles\n", body.link.c_str(), body.triangles)
        : std::printf("body       %s: %s\n", body.link.c_str(), body.shape.c_str());
  for (const auto& [one, other] : report.unchecked)
    std::printf("unchecked  %s against %s\n", one.c_str(), other.c_str());
  for (const auto& [one, other] : robot.built_in)
    std::printf("unchecked  %s against %s, built into each other\n", one.c_str(), other.c_str());
  const InverseTrial& trial = robot.inverse;
  if (trial.poses > 0) printTrial(trial);
  for (const std::string& trap : report.traps) std::printf("note       %s\n", trap.c_str());
}

void printRobotJson(const Reported& robot) {
  const RobotReport& report = robot.report;
  const Eigen::Isometry3d& zero = report.base_from_flange_at_zero;
  const Eigen::Quaterniond turn(zero.linear());
  nlohmann::ordered_json joints = nlohmann::json::array();
  for (const DrivenJoint& joint : report.joints)
    joints.push_back({{"name", joint.name},
                      {"kind", joint.kind == JointKind::Linear ? "linear" : "rotary"},
                      {"lower", shownValue(joint, joint.low)},
                      {"upper", shownValue(joint, joint.high)},
                      {"speed", shownValue(joint, joint.max_speed)}});
  nlohmann::ordered_json bodies = nlohmann::json::array();
  for (const ReportedBody& body : report.bodies)
    bodies.push_back({{"link", body.link}, {"shape", body.shape}, {"triangles", body.triangles}});
  const nlohmann::ordered_json json = {
      {"name", report.name},
      {"class", report.kinematic_class},
      {"redundancy", report.redundancy},
      {"flange", report.flange},
      {"flange_at_zero_mm", {zero.translation().x(), zero.translation().y(), zero.translation().z()}},
      {"flange_at_zero_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}},
      {"reach_mm", report.reach_mm},
      {"joints", joints},
      {"bodies", bodies},
      {"unchecked", report.unchecked},
      {"built_in", robot.built_in},
      {"traps", report.traps},
      {"inverse",
       {{"poses", robot.inverse.poses},
        {"reached", robot.inverse.reached},
        {"recovered", robot.inverse.recovered},
        {"regular", robot.inverse.regular},
        {"regular_recovered", robot.inverse.regular_recovered},
        {"tip_error_mm", robot.inverse.tip_error_mm},
        {"turn_error_rad", robot.inverse.turn_error_rad},
        {"ends", robot.inverse.ends}}},
  };
  std::printf("%s\n", json.dump(2).c_str());
}

}  // namespace

void addRobot(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "robot", "Report on a robot's description: chain, class, zero pose, reach, limits, bodies, traps");
  const auto arguments = std::make_shared<RobotArguments>();
  subcommand->add_option("file", arguments->path, "URDF, or cell file (.yaml)")->required();
  subcommand->add_option("--write", arguments->written, "Write the one URDF that it becomes");
  subcommand->add_option("--poses", arguments->poses, "Number of random poses to invert")
      ->check(CLI::Range(0, 1000000));
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] {
      const std::string urdf = readMachineDescription(arguments->path);
      const Reported report = reportedRobot(urdf, arguments->poses);
      if (!arguments->written.empty()) writeFile(arguments->written, urdf);
      chosen.format == OutputFormat::Json ? printRobotJson(report) : printRobot(report);
    };
  });
}

}  // namespace lamina::cli
