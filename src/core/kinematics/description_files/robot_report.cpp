// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/robot_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "kinematics/arm/arm_model.hpp"
#include "kinematics/description_files/flange.hpp"
#include "kinematics/model/link_motion.hpp"
#include "lamina/base/random.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"

namespace lamina {
namespace {

constexpr int kReachPoses = 2000;
constexpr double kAlongAxis = 0.99;  // cosine
constexpr double kSamePlace = 1e-3;  // mm
constexpr double kSameTurn = 1e-6;   // rad

ReportedBody reported(const LinkBody& body) {
  constexpr std::array<const char*, 5> kNames = {"box", "cylinder", "cone", "sphere", "mesh"};
  ReportedBody shown{body.link, kNames[body.shape.index()], 0};
  if (const auto* mesh = std::get_if<MeshShape>(&body.shape)) shown.triangles = mesh->mesh->triangles.size();
  return shown;
}

double reachOf(const ArmModel& arm, const std::string& flange) {
  const Screw& first = arm.chain().arm.screws.front();
  Random random(1);
  double reach = 0.0;
  for (int i = 0; i < kReachPoses; ++i) {
    JointValues values = JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size()));
    for (const Eigen::Index j : arm.chain().arm_index) {
      const DrivenJoint& joint = arm.joints()[static_cast<std::size_t>(j)];
      values[j] = random.uniform(std::max(joint.low, -M_PI), std::min(joint.high, M_PI));
    }
    const Point3 at = arm.bedFromLinks(values).at(flange).translation() - first.point;
    reach = std::max(reach, first.direction.cross(at).norm());
  }
  return reach;
}

std::vector<std::string> mimicTraps(const urdf::ModelInterface& model) {
  std::vector<std::string> traps;
  for (const auto& [name, joint] : model.joints_)
    if (joint->mimic) traps.push_back("joint '" + name + "' mimics '" + joint->mimic->joint_name + "'");
  return traps;
}

std::vector<std::string> trapsOf(const urdf::ModelInterface& model, const ArmModel& arm,
                                 const std::string& flange) {
  std::vector<std::string> traps = mimicTraps(model);
  const double cosine = flangeAxis(model, flange).z();
  if (std::abs(cosine) < kAlongAxis)
    traps.push_back("z of '" + flange + "' lies across the last axis");
  else if (cosine < 0.0)
    traps.push_back("z of '" + flange + "' lies against the last axis");
  if (flange != "tool0") traps.push_back("there is no link tool0; '" + flange + "' is taken for the flange");
  const JointValues zero = JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size()));
  const auto links = arm.bedFromLinks(zero);
  if (links.count("base") != 0 && links.count("base_link") != 0) {
    const Eigen::Isometry3d off = links.at("base_link").inverse() * links.at("base");
    if (off.translation().norm() > kSamePlace || Eigen::AngleAxisd(off.linear()).angle() > kSameTurn)
      traps.emplace_back("base differs from base_link: programs of the controller count from base");
  }
  const Eigen::Matrix3d& up = links.at(model.getRoot()->name).linear();
  if (arm.chain().arm.screws.front().direction.dot(up.col(2)) < -kAlongAxis)
    traps.emplace_back("axis 1 points downwards: it turns against the right hand seen from above");
  return traps;
}

}  // namespace

std::string withBedAndNozzle(const std::string& urdf) {
  const auto model = parseMachine(urdf);
  std::string added;
  if (!model->getLink("bed"))
    added += "<link name=\"bed\"/><joint name=\"root_to_bed\" type=\"fixed\"><parent link=\"" +
             model->getRoot()->name + "\"/><child link=\"bed\"/></joint>";
  if (!model->getLink("nozzle"))
    added += "<link name=\"nozzle\"/><joint name=\"flange_to_nozzle\" type=\"fixed\"><parent link=\"" +
             flangeOf(*model, "") + "\"/><child link=\"nozzle\"/></joint>";
  std::string text = urdf;
  return text.insert(text.rfind("</robot>"), added);
}

RobotReport robotReport(const std::string& urdf) {
  const std::string text = withBedAndNozzle(urdf);
  const auto model = parseMachine(text);
  const auto read = kinematicModelFromUrdf(text);
  const ArmModel& arm = requireArm(*read);
  RobotReport report;
  report.name = arm.name();
  for (const int j : arm.chain().whole.outward)
    report.joints.push_back(arm.joints()[static_cast<std::size_t>(j)]);
  report.kinematic_class = arm.kinematicClass();
  if (arm.redundancy() != nullptr)
    report.redundancy = "arm angle: the turn of the elbow about the line from the shoulder to the wrist";
  report.flange = model->getLink("tool0") || model->getLink("flange") ? flangeOf(*model, "") : "nozzle";
  const auto links = arm.bedFromLinks(JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size())));
  report.base_from_flange_at_zero = links.at(model->getRoot()->name).inverse() * links.at(report.flange);
  report.reach_mm = reachOf(arm, report.flange);
  const LinkBodies bodies = linkBodies(text);
  for (const RigidGroup& group : bodies.groups)
    for (const LinkBody& body : group.bodies) report.bodies.push_back(reported(body));
  report.unchecked = uncheckedLinks(bodies);
  report.traps = trapsOf(*model, arm, report.flange);
  return report;
}

}  // namespace lamina
