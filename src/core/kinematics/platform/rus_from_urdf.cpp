// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/platform/rus_from_urdf.hpp"

#include <cmath>
#include <string>

#include "kinematics/model/link_motion.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/platform/rus_kinematics.hpp"

namespace lamina {
namespace {

constexpr double kSame = 1e-6;  // mm per mm: digits of a URDF

using Model = urdf::ModelInterface;
using Poses = std::map<std::string, Eigen::Isometry3d>;

/// A URDF with all its joints at 0, asked for what a platform has.
class Reader {
 public:
  Reader(const Model& model, const LinkTree& links) : model_(model), poses_(links.rootFromLinks({})) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw InvalidConfig("machine '" + model_.getName() + "': " + what);
  }

  const urdf::Joint& joint(const std::string& name) const {
    const auto found = model_.getJoint(name);
    if (!found) refuse("there is no joint '" + name + "', which a platform of six cranks has");
    return *found;
  }

  const urdf::JointLimits& limits(const std::string& name) const {
    const urdf::Joint& limited = joint(name);
    if (!limited.limits || !(limited.limits->lower < limited.limits->upper))
      refuse("joint '" + name + "' has no limits, the lower less than the upper");
    return *limited.limits;
  }

  /// A link at all joints zero [mm, root frame].
  const Eigen::Isometry3d& pose(const std::string& link) const {
    const auto found = poses_.find(link);
    if (found == poses_.end()) refuse("there is no link '" + link + "'");
    return found->second;
  }

  const std::string& parentOf(const std::string& joint_name) const {
    return joint(joint_name).parent_link_name;
  }
  const Eigen::Isometry3d& childPose(const std::string& joint_name) const {
    return pose(joint(joint_name).child_link_name);
  }
  Point3 axis(const std::string& joint_name) const {
    const urdf::Vector3& axis = joint(joint_name).axis;
    return childPose(joint_name).linear() * Point3(axis.x, axis.y, axis.z);
  }

  /// @throws InvalidConfig unless only fixed joints lie between the link and the ancestor
  void requireFixed(const std::string& link, const std::string& ancestor) const {
    auto at = model_.getLink(link);
    if (!at) refuse("there is no link '" + link + "'");
    while (at->name != ancestor && at->parent_joint && at->parent_joint->type == urdf::Joint::FIXED)
      at = model_.getLink(at->parent_joint->parent_link_name);
    if (at->name != ancestor)
      refuse("link '" + link + "' hangs on a joint that moves, or elsewhere; expected fixed on '" + ancestor +
             "'");
  }

  void require(bool is_so, const std::string& joint_name, const std::string& expected) const {
    if (!is_so) refuse("joint '" + joint_name + "' is not as it has to be with all joints at 0: " + expected);
  }

 private:
  const Model& model_;
  Poses poses_;
};

bool areSame(const Point3& a, const Point3& b) { return (a - b).norm() < kSame; }

/// The platform's own joints turn and move it as `PlatformAngles` say.
void requirePlatformJoints(const Reader& reader, const Eigen::Isometry3d& root_from_home) {
  static const std::pair<const char*, int> joints[] = {{"platform_x", 0}, {"platform_y", 1},
                                                       {"platform_z", 2}, {"platform_b", 1},
                                                       {"platform_a", 0}, {"platform_c", 2}};
  std::string parent = reader.parentOf("platform_x");
  for (const auto& [name, along] : joints) {
    const bool is_linear = name[9] >= 'x';
    const auto type = is_linear ? urdf::Joint::PRISMATIC : urdf::Joint::REVOLUTE;
    reader.require(reader.joint(name).type == type, name,
                   is_linear ? "expected prismatic" : "expected revolute");
    reader.require(reader.parentOf(name) == parent, name, "expected on link '" + parent + "'");
    reader.require(areSame(reader.axis(name), root_from_home.linear().col(along)), name,
                   "its axis has to be that of its name in the frame of the mobile platform");
    reader.require(areSame(reader.childPose(name).translation(), root_from_home.translation()), name,
                   "it has to stand at the origin of the mobile platform");
    parent = reader.joint(name).child_link_name;
  }
}

DrivenJoint crankJoint(const Reader& reader, const std::string& name) {
  const urdf::JointLimits& limits = reader.limits(name);
  reader.require(reader.joint(name).type == urdf::Joint::REVOLUTE, name, "expected revolute");
  if (!(limits.velocity > 0.0))
    reader.refuse("the velocity of joint '" + name + "' is " + numberText(limits.velocity) +
                  " rad/s; must be positive");
  return {name, JointKind::Rotary, limits.lower, limits.upper, limits.velocity};
}

/// A leg as it hangs with all joints at 0: the coupler straight on from the crank.
RusLeg legOf(const Reader& reader, const std::string& number, const Eigen::Isometry3d& root_from_base,
             const Eigen::Isometry3d& root_from_home) {
  const std::string crank = "crank_" + number;
  const std::string fold = "universal_" + number + "_a";
  const std::string lean = "universal_" + number + "_b";
  const std::string ball = "spherical_" + number;
  const Eigen::Matrix3d base_from_root = root_from_base.linear().transpose();
  RusLeg leg;
  leg.axis = base_from_root * reader.axis(crank);
  const Point3 elbow = root_from_base.inverse() * reader.childPose(fold).translation();
  leg.motor = root_from_base.inverse() * reader.childPose(crank).translation();
  // The crank turns where its end does, wherever along its axis the joint's origin stands.
  leg.motor += leg.axis * leg.axis.dot(elbow - leg.motor);
  leg.crank_mm = (elbow - leg.motor).norm();
  if (!(leg.crank_mm > kSame)) reader.refuse("joint '" + crank + "' has a crank of no length");
  leg.rest = (elbow - leg.motor) / leg.crank_mm;
  const Point3 end = root_from_base.inverse() * reader.pose("coupler_end_" + number).translation();
  leg.coupler_mm = (end - elbow).norm();

  reader.requireFixed("coupler_end_" + number, reader.joint(lean).child_link_name);
  reader.require(reader.parentOf(fold) == reader.joint(crank).child_link_name, fold, "expected on the crank");
  reader.require(reader.parentOf(lean) == reader.joint(fold).child_link_name, lean, "expected on " + fold);
  reader.require(areSame(reader.axis(fold), reader.axis(crank)), fold, "its axis has to be the crank's");
  reader.require(areSame((end - elbow) / leg.coupler_mm, leg.rest), lean,
                 "the coupler has to lie straight on from the crank");
  reader.require(areSame((base_from_root * reader.axis(lean)).cross(leg.rest), leg.axis), lean,
                 "it has to lean the coupler towards the crank's axis");
  reader.require(areSame(reader.childPose(lean).translation(), reader.childPose(fold).translation()), lean,
                 "it has to stand where " + fold + " does");

  const Eigen::Isometry3d platform_from_ball = root_from_home.inverse() * reader.childPose(ball);
  leg.ball = platform_from_ball.translation();
  leg.socket = platform_from_ball.linear().col(0);
  leg.low = reader.limits(crank).lower;
  leg.high = reader.limits(crank).upper;
  leg.greatest_lean = std::min(-reader.limits(lean).lower, reader.limits(lean).upper);
  leg.greatest_swing = reader.limits(ball).upper;
  return leg;
}

/// A leg is built in the branch in which its crank is within its range at home.
CrankBranch branchOf(const Reader& reader, const RusPlatform& platform, std::size_t index) {
  const RusLeg& leg = platform.legs[index];
  for (const CrankBranch branch : {CrankBranch::Behind, CrankBranch::Ahead}) {
    const auto crank = crankAngle(leg, platform.home * leg.ball, branch);
    if (crank && *crank >= leg.low && *crank <= leg.high) return branch;
  }
  reader.refuse("leg " + std::to_string(index + 1) +
                " does not reach its ball at home within the limits of crank_" + std::to_string(index + 1));
}

}  // namespace

RusDescription rusDescription(const urdf::ModelInterface& model, const LinkTree& links) {
  const Reader reader(model, links);
  const std::string& base = reader.parentOf("crank_1");
  const std::string& mobile = reader.joint("platform_c").child_link_name;
  const Eigen::Isometry3d& root_from_home = reader.pose(mobile);
  requirePlatformJoints(reader, root_from_home);
  reader.requireFixed(reader.parentOf("platform_x"), base);
  reader.requireFixed("bed", model.getRoot()->name);
  reader.requireFixed(base, model.getRoot()->name);
  reader.requireFixed("nozzle", mobile);

  RusDescription description;
  description.root_from_base = reader.pose(base);
  description.base_from_bed = description.root_from_base.inverse() * reader.pose("bed");
  description.platform_from_nozzle = root_from_home.inverse() * reader.pose("nozzle");
  description.platform.home = description.root_from_base.inverse() * root_from_home;
  for (std::size_t i = 0; i < kLegs; ++i) {
    const std::string number = std::to_string(i + 1);
    reader.requireFixed(reader.parentOf("crank_" + number), base);
    reader.requireFixed(reader.joint("spherical_" + number).child_link_name, mobile);
    description.cranks.push_back(crankJoint(reader, "crank_" + number));
    RusLeg& leg = description.platform.legs[i];
    leg = legOf(reader, number, description.root_from_base, root_from_home);
    leg.branch = branchOf(reader, description.platform, i);
  }
  return description;
}

RusDescription rusDescriptionFromUrdf(const std::string& text) {
  const auto model = parseMachine(text);
  return rusDescription(*model, LinkTree(*model));
}

}  // namespace lamina
