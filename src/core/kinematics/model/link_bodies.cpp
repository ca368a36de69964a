// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/link_bodies.hpp"

#include <tinyxml.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/model/body_shape.hpp"
#include "kinematics/model/link_motion.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kOnePlace = 1e-3;  // mm: digits of a URDF

/// The joint by which a group hangs.
struct GroupJoint {
  std::size_t parent = 0;
  std::string parent_link;  ///< of that group
  bool is_rotary = false;
  bool goes_on = false;  ///< turns where the joint of its parent does, as those of a universal joint
};

using LinkNames = std::pair<std::string, std::string>;

/// Each link with solid pieces of a group once.
std::set<std::string> solidLinks(const RigidGroup& group) {
  std::set<std::string> links;
  for (const LinkBody& body : group.bodies) links.insert(body.link);
  return links;
}

/// Gathers the groups of a tree of links.
class GroupCollector {
 public:
  explicit GroupCollector(const urdf::ModelInterface& model) {
    found_.groups.emplace_back();
    joints_.emplace_back();
    add(*model.getRoot(), 0, Eigen::Isometry3d::Identity());
    addPairs();
  }

  LinkBodies take() { return std::move(found_); }

 private:
  /// @param group_from_link  from the frame of the joint by which the group hangs [mm]
  void add(const urdf::Link& link, std::size_t group, const Eigen::Isometry3d& group_from_link) {
    found_.groups[group].links.push_back(link.name);
    if (link.name == "bed") found_.bed = group;
    for (const auto& collision : link.collision_array)
      found_.groups[group].bodies.push_back(
          {link.name, shapeOf(*collision, link.name), poseOf(collision->origin)});
    auto children = link.child_links;
    std::sort(children.begin(), children.end(),
              [](const auto& a, const auto& b) { return a->name < b->name; });
    for (const auto& child : children) {
      const urdf::Joint& joint = *child->parent_joint;
      const Eigen::Isometry3d group_from_child =
          group_from_link * poseOf(joint.parent_to_joint_origin_transform);
      if (joint.type == urdf::Joint::FIXED)
        add(*child, group, group_from_child);
      else
        add(*child, groupHangingOn(group, joint, group_from_child), Eigen::Isometry3d::Identity());
    }
  }

  std::size_t groupHangingOn(std::size_t parent, const urdf::Joint& joint,
                             const Eigen::Isometry3d& parent_from_joint) {
    GroupJoint hung;
    hung.parent = parent;
    hung.parent_link = joint.parent_link_name;
    hung.is_rotary = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
    hung.goes_on =
        hung.is_rotary && joints_[parent].is_rotary && parent_from_joint.translation().norm() < kOnePlace;
    found_.groups.push_back({{}, {}, parent, joint.name});
    joints_.push_back(hung);
    return found_.groups.size() - 1;
  }

  /// The links that the joints between two groups connect; nothing if these do not turn about one point, or
  /// have something solid in between.
  std::optional<LinkNames> jointedLinks(std::size_t group, std::size_t on) const {
    std::size_t hung = group;
    while (joints_[hung].parent != on) {
      if (!joints_[hung].goes_on || !found_.groups[joints_[hung].parent].bodies.empty()) return std::nullopt;
      hung = joints_[hung].parent;
    }
    return LinkNames{joints_[hung].parent_link, found_.groups[group].links.front()};
  }

  /// What else is fixed to links that a joint connects is not built to touch: fences and arms have one root.
  void addPairs() {
    for (std::size_t b = 1; b < found_.groups.size(); ++b)
      for (std::size_t a = 0; a < b; ++a) {
        const std::set<std::string> ones = solidLinks(found_.groups[a]);
        const std::set<std::string> others = solidLinks(found_.groups[b]);
        std::size_t checked = ones.size() * others.size();
        const auto jointed = jointedLinks(b, a);
        if (jointed && ones.count(jointed->first) > 0 && others.count(jointed->second) > 0) {
          found_.neighbours.push_back(*jointed);
          --checked;
        }
        if (checked > 0) found_.pairs.emplace_back(a, b);
      }
  }

  LinkBodies found_;
  std::vector<GroupJoint> joints_;  ///< of the groups; that of the first has no meaning
};

std::vector<LinkNames> ignoredLinks(const std::string& urdf, const urdf::ModelInterface& model) {
  TiXmlDocument document;
  document.Parse(urdf.c_str());
  std::vector<LinkNames> ignored;
  for (const TiXmlElement* each = document.RootElement()->FirstChildElement("lamina_ignore"); each != nullptr;
       each = each->NextSiblingElement("lamina_ignore")) {
    const auto link = [&](const char* attribute) -> std::string {
      const char* const name = each->Attribute(attribute);
      if (name != nullptr && model.getLink(name)) return name;
      throw InvalidConfig("machine '" + model.getName() + "' has no link '" + (name == nullptr ? "" : name) +
                          "', which is to be ignored; expected one of its links (cell.ignore)");
    };
    std::string first = link("link1");
    ignored.emplace_back(std::move(first), link("link2"));
  }
  return ignored;
}

bool areNamed(const std::vector<LinkNames>& pairs, const std::string& a, const std::string& b) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const LinkNames& pair) {
    return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
  });
}

}  // namespace

bool areUnchecked(const LinkBodies& bodies, const std::string& a, const std::string& b) {
  return areNamed(bodies.neighbours, a, b) || areNamed(bodies.ignored, a, b);
}

bool areUnchecked(const LinkBodies& bodies, const RigidGroup& a, const RigidGroup& b) {
  return std::any_of(a.bodies.begin(), a.bodies.end(), [&](const LinkBody& one) {
    return std::any_of(b.bodies.begin(), b.bodies.end(),
                       [&](const LinkBody& other) { return areUnchecked(bodies, one.link, other.link); });
  });
}

std::vector<LinkNames> uncheckedLinks(const LinkBodies& bodies) {
  std::vector<LinkNames> unchecked = bodies.neighbours;
  unchecked.insert(unchecked.end(), bodies.ignored.begin(), bodies.ignored.end());
  return unchecked;
}

LinkBodies linkBodies(const std::string& urdf) {
  const auto model = parseMachine(urdf);
  if (!model->getLink("bed")) throw InvalidConfig("machine '" + model->getName() + "' has no link 'bed'");
  LinkBodies bodies = GroupCollector(*model).take();
  bodies.ignored = ignoredLinks(urdf, *model);
  return bodies;
}

}  // namespace lamina
