// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "kinematics/model/external_joint.hpp"
#include "kinematics/model/link_motion.hpp"
#include "kinematics/model/serial_chain.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kChainMillimetres = 1e3;  // in the metre of URDF
constexpr double kEndless = 1e6;           // mm, as of `isEndless`
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Model = urdf::ModelInterface;

[[noreturn]] void refuse(const Model& model, const urdf::Joint& joint, const std::string& what) {
  throw InvalidConfig("machine '" + model.getName() + "': joint '" + joint.name + "' " + what);
}

bool isFixed(const urdf::Joint& joint) { return joint.type == urdf::Joint::FIXED; }

JointKind kindOf(const Model& model, const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::PRISMATIC:
      return JointKind::Linear;
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return JointKind::Rotary;
    default:
      refuse(model, joint, "is neither prismatic, revolute, continuous nor fixed");
  }
}

/// Of the joint's value in the URDF [m, rad].
double unitOf(JointKind kind) { return kind == JointKind::Linear ? kChainMillimetres : 1.0; }

DrivenJoint drivenJoint(const Model& model, const urdf::Joint& joint) {
  DrivenJoint driven{joint.name, kindOf(model, joint), -kInfinity, kInfinity, 0.0};
  if (!joint.limits) refuse(model, joint, "has no limits");
  const double unit = unitOf(driven.kind);
  driven.max_speed = unit * joint.limits->velocity;
  if (!(driven.max_speed > 0.0))
    refuse(model, joint, "has a velocity of " + numberText(joint.limits->velocity) + "; must be positive");
  if (joint.type == urdf::Joint::CONTINUOUS) return driven;
  if (!(joint.limits->lower < joint.limits->upper))
    refuse(model, joint,
           "has limits " + numberText(joint.limits->lower) + " to " + numberText(joint.limits->upper) +
               "; the lower must be the lesser");
  driven.low = unit * joint.limits->lower;
  driven.high = unit * joint.limits->upper;
  if (driven.kind == JointKind::Linear && driven.high - driven.low >= kEndless) driven.high = kInfinity;
  return driven;
}

std::vector<const urdf::Joint*> jointsToRoot(const Model& model, const std::string& name) {
  std::vector<const urdf::Joint*> joints;
  for (const urdf::Link* link = &requireLink(model, name); link->parent_joint;
       link = &requireLink(model, link->parent_joint->parent_link_name))
    joints.push_back(link->parent_joint.get());
  return joints;
}

/// A joint between bed and nozzle, and whether it carries the bed.
struct PlacedJoint {
  const urdf::Joint* joint;
  bool carries_bed;
};

std::vector<PlacedJoint> jointsFromBedToNozzle(const Model& model) {
  std::vector<const urdf::Joint*> bed = jointsToRoot(model, "bed");
  std::vector<const urdf::Joint*> nozzle = jointsToRoot(model, "nozzle");
  while (!bed.empty() && !nozzle.empty() && bed.back() == nozzle.back()) {
    bed.pop_back();
    nozzle.pop_back();
  }
  std::vector<PlacedJoint> joints;
  for (const urdf::Joint* joint : bed)
    if (!isFixed(*joint)) joints.push_back({joint, true});
  for (auto joint = nozzle.rbegin(); joint != nozzle.rend(); ++joint)
    if (!isFixed(**joint)) joints.push_back({*joint, false});
  return joints;
}

/// Where a joint stands in the order of the kinematic model: joints of an arm, which have any names, by the
/// chain; those of machines by kind and name, external ones by name.
auto rankOf(const Model& model, const urdf::Joint& joint) {
  const bool is_external = isExternal(joint.name);
  const bool is_named = is_external || model.getJoint(kAxisNames[0]);
  const JointKind kind = is_external || !is_named ? JointKind::Linear : kindOf(model, joint);
  return std::make_tuple(is_external, kind, is_named ? joint.name : std::string());
}

void requireFew(const Model& model, std::size_t count) {
  if (count <= static_cast<std::size_t>(kMostJoints)) return;
  throw InvalidConfig("machine '" + model.getName() + "' has " + std::to_string(count) +
                      " joints between bed and nozzle; at most " + std::to_string(kMostJoints) +
                      " are understood");
}

/// The driven joints in the order of the kinematic model.
std::vector<const urdf::Joint*> inOrder(const Model& model, const std::vector<PlacedJoint>& placed) {
  std::vector<const urdf::Joint*> joints;
  for (const PlacedJoint& each : placed) {
    if (each.joint->mimic)
      refuse(model, *each.joint, "mimics another; between bed and nozzle each is driven");
    joints.push_back(each.joint);
  }
  requireFew(model, joints.size());
  std::stable_sort(joints.begin(), joints.end(), [&](const urdf::Joint* a, const urdf::Joint* b) {
    return rankOf(model, *a) < rankOf(model, *b);
  });
  return joints;
}

int indexOf(const SerialChain& chain, const std::string& joint) {
  for (std::size_t j = 0; j < chain.joints.size(); ++j)
    if (chain.joints[j].name == joint) return static_cast<int>(j);
  return ChainLink::kNone;
}

ChainLink linkOf(const Model& model, const SerialChain& chain, const urdf::Link& source) {
  ChainLink link;
  link.name = source.name;
  if (!source.parent_joint) return link;
  const urdf::Joint& joint = *source.parent_joint;
  link.parent_from_link_at_zero = poseOf(joint.parent_to_joint_origin_transform);
  if (isFixed(joint)) return link;
  link.kind = kindOf(model, joint);
  link.moved_by = joint.name;
  link.axis = directionOf(model, joint);
  link.joint = indexOf(chain, joint.mimic ? joint.mimic->joint_name : joint.name);
  if (link.joint == ChainLink::kNone)
    refuse(model, joint, "moves, but neither stands between bed and nozzle nor mimics one that does");
  if (!joint.mimic) return link;
  const JointKind driver = chain.joints[static_cast<std::size_t>(link.joint)].kind;
  link.factor = joint.mimic->multiplier * unitOf(link.kind) / unitOf(driver);
  link.offset = joint.mimic->offset * unitOf(link.kind);
  return link;
}

std::vector<ChainLink> linksOf(const Model& model, const SerialChain& chain) {
  std::vector<const urdf::Link*> sources = {model.getRoot().get()};
  std::vector<ChainLink> links = {linkOf(model, chain, *sources[0])};
  for (std::size_t l = 0; l < sources.size(); ++l) {
    for (const auto& child : sources[l]->child_links) {
      sources.push_back(child.get());
      links.push_back(linkOf(model, chain, *child));
      links.back().parent = static_cast<int>(l);
    }
  }
  return links;
}

Screw screwOf(const ChainLink& link, const Eigen::Isometry3d& bed_from_link, bool carries_bed) {
  const double sense = carries_bed ? -1.0 : 1.0;
  return {sense * (bed_from_link.linear() * link.axis), bed_from_link.translation()};
}

}  // namespace

SerialChain serialChain(const urdf::ModelInterface& model, const std::string& text) {
  SerialChain chain;
  chain.name = model.getName();
  chain.urdf = text;
  const std::vector<PlacedJoint> placed = jointsFromBedToNozzle(model);
  for (const urdf::Joint* joint : inOrder(model, placed)) chain.joints.push_back(drivenJoint(model, *joint));
  chain.links = linksOf(model, chain);

  const JointValues zero = JointValues::Zero(static_cast<Eigen::Index>(chain.joints.size()));
  // A joint that mimics may have an offset, but never stands between bed and nozzle.
  const auto bed_from_links = bedFromLinks(chain, zero);
  chain.bed_from_nozzle_at_zero = bed_from_links.at("nozzle");
  chain.screws.resize(chain.joints.size());
  for (const PlacedJoint& each : placed) {
    const int index = indexOf(chain, each.joint->name);
    const auto link = std::find_if(chain.links.begin(), chain.links.end(), [&](const ChainLink& candidate) {
      return candidate.moved_by == each.joint->name;
    });
    chain.outward.push_back(index);
    chain.screws[static_cast<std::size_t>(index)] =
        screwOf(*link, bed_from_links.at(link->name), each.carries_bed);
  }
  return chain;
}

}  // namespace lamina
