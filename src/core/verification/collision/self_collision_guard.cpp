// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/self_collision_guard.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "kinematics/model/link_motion.hpp"
#include "kinematics/model/link_tree.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {

/// Two groups of links that one or two rotary joints move against each other.
struct JointedPair {
  const RigidGroup* near = nullptr;
  const RigidGroup* far = nullptr;
  /// Of the kinematic model; the first next to `near`. Both are the same of groups with one joint between.
  std::array<Eigen::Index, 2> joints{};
  std::array<std::string, 2> axis_links{};  ///< whose origins lie on the axes of the joints

  bool hasOneJoint() const { return joints[0] == joints[1]; }
};

/// Every link over the root of the tree [mm], at values of the joints of a pair [rad]; of one joint the
/// first.
using PairPoses = std::function<std::map<std::string, Eigen::Isometry3d>(double first, double second)>;

constexpr double kWholeTurn = 2.0 * M_PI;

/// At which values of one or two rotary joints two groups of links are in each other.
class CollisionTable {
 public:
  CollisionTable(const JointedPair& pair, const std::vector<DrivenJoint>& joints, const PairPoses& poses);

  /// Whether the groups may be in each other there. Never false where they are.
  bool isBanned(const JointValues& values) const {
    return cells_[columns_.cellOf(values) * rows_.count + rows_.cellOf(values)];
  }
  const std::string& text() const { return text_; }

 private:
  /// The cells of one joint: of its limits, or of a whole turn if they are further apart.
  struct Cells {
    Eigen::Index joint = 0;
    double low = 0.0;    // [rad]
    double width = 0.0;  // of a cell [rad]
    std::size_t count = 0;

    std::size_t cellOf(const JointValues& values) const;
    double middleOf(std::size_t cell) const { return low + width * (static_cast<double>(cell) + 0.5); }
  };
  struct Filling;

  static Cells cellsOf(Eigen::Index index, const DrivenJoint& joint, double finest);
  static Cells oneCell(const Cells& all) { return {all.joint, all.low, 2.0 * kWholeTurn, 1}; }

  Cells columns_;
  Cells rows_;
  std::vector<bool> cells_;
  std::string text_;
};

namespace {

constexpr double kFinest = toRadians(2.0);
/// Of one joint cells are cheap: a plate that turns closely above its bed is not banned everywhere.
constexpr double kFinestOfOne = toRadians(0.1);

std::string namesOf(const RigidGroup& group) {
  std::string names;
  for (std::size_t i = 0; i < group.bodies.size(); ++i)
    if (i == 0 || group.bodies[i].link != group.bodies[i - 1].link)
      names += (names.empty() ? "'" : " or '") + group.bodies[i].link + "'";
  return names;
}

std::optional<Eigen::Index> rotaryJoint(const std::vector<DrivenJoint>& joints, const std::string& name) {
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].name == name && joints[j].kind == JointKind::Rotary) return static_cast<Eigen::Index>(j);
  return std::nullopt;
}

/// The groups that hang on the two joints between two groups, the first next to `near`, or twice that on the
/// only one; nothing if there are more joints between them.
std::optional<std::array<const RigidGroup*, 2>> hangingBetween(const LinkBodies& bodies, std::size_t near,
                                                               std::size_t far) {
  const RigidGroup& a = bodies.groups[near];
  const RigidGroup& b = bodies.groups[far];
  const RigidGroup& between = bodies.groups[b.parent];
  if (b.joint.empty()) return std::nullopt;
  if (b.parent == near) return std::array{&b, &b};
  if (!between.joint.empty() && between.parent == near) return std::array{&between, &b};
  if (!a.joint.empty() && a.parent == b.parent) return std::array{&a, &b};
  return std::nullopt;
}

/// The groups, and of those that hold links which are not checked against each other, as the first link of an
/// arm and the one that carries it beside a fence, each link of the far one with what else is in the near
/// one.
std::vector<std::pair<RigidGroup, RigidGroup>> checkedParts(const LinkBodies& bodies, const RigidGroup& near,
                                                            const RigidGroup& far) {
  if (!areUnchecked(bodies, near, far)) return {{near, far}};
  std::vector<std::pair<RigidGroup, RigidGroup>> parts;
  for (const LinkBody& body : far.bodies) {
    const bool is_known = std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
      return part.second.bodies.front().link == body.link;
    });
    if (is_known) continue;
    std::pair<RigidGroup, RigidGroup> part;
    std::copy_if(near.bodies.begin(), near.bodies.end(), std::back_inserter(part.first.bodies),
                 [&](const LinkBody& other) { return !areUnchecked(bodies, other.link, body.link); });
    std::copy_if(far.bodies.begin(), far.bodies.end(), std::back_inserter(part.second.bodies),
                 [&](const LinkBody& other) { return other.link == body.link; });
    if (!part.first.bodies.empty()) parts.push_back(std::move(part));
  }
  return parts;
}

std::optional<JointedPair> jointedPair(const LinkBodies& bodies, std::size_t near, std::size_t far,
                                       const std::vector<DrivenJoint>& joints) {
  const auto hanging = hangingBetween(bodies, near, far);
  if (!hanging) return std::nullopt;
  JointedPair pair{&bodies.groups[near], &bodies.groups[far]};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto joint = rotaryJoint(joints, (*hanging)[i]->joint);
    if (!joint) return std::nullopt;
    pair.joints[i] = *joint;
    pair.axis_links[i] = (*hanging)[i]->links.front();
  }
  return pair;
}

}  // namespace

/// Bisects the range of both joints until it is clear or one cell.
struct CollisionTable::Filling {
  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;

    std::size_t size() const { return end - begin; }
    std::size_t half() const { return (begin + end) / 2; }
  };

  CollisionTable& table;
  const JointedPair& pair;
  const PairPoses& poses;
  std::vector<Solid> near_solids;
  /// As they are; of groups without meshes none. Trees of triangles take long to make.
  std::vector<Solid> near_exact;
  std::vector<Solid> far_exact;

  void fill(Range columns, Range rows) {
    if (isClear(columns, rows)) return;
    if (columns.size() == 1 && rows.size() == 1) {
      table.cells_[columns.begin * table.rows_.count + rows.begin] = meetAsTheyAre(columns, rows);
    } else if (columns.size() >= rows.size()) {
      fill({columns.begin, columns.half()}, rows);
      fill({columns.half(), columns.end}, rows);
    } else {
      fill(columns, {rows.begin, rows.half()});
      fill(columns, {rows.half(), rows.end});
    }
  }

  /// Bodies are looked at in the middle of the range, those of the far group larger by as much as they move
  /// within it.
  bool isClear(Range columns, Range rows) const {
    const auto middle = [](const Cells& cells, Range range) {
      return cells.low + 0.5 * cells.width * static_cast<double>(range.begin + range.end);
    };
    const double half_column = 0.5 * table.columns_.width * static_cast<double>(columns.size());
    const double half_row =
        pair.hasOneJoint() ? 0.0 : 0.5 * table.rows_.width * static_cast<double>(rows.size());
    const auto links = poses(middle(table.columns_, columns), middle(table.rows_, rows));
    const Point3 first_axis = links.at(pair.axis_links[0]).translation();
    const Point3 second_axis = links.at(pair.axis_links[1]).translation();
    for (const LinkBody& body : pair.far->bodies) {
      const Eigen::Isometry3d pose = links.at(body.link) * body.link_from_body;
      const double radius = boundingRadius(body.shape);
      const double by_second = half_row * ((pose.translation() - second_axis).norm() + radius);
      const double by_first = half_column * ((pose.translation() - first_axis).norm() + radius + by_second);
      if (meetsNear(Solid(grown(body.shape, by_first + by_second)), pose, links)) return false;
    }
    return true;
  }

  /// Hulls of meshes that are hollow or bent meet where the meshes do not: of these the middle counts.
  bool meetAsTheyAre(Range column, Range row) const {
    if (near_exact.empty()) return true;
    const auto links = poses(table.columns_.middleOf(column.begin), table.rows_.middleOf(row.begin));
    for (std::size_t f = 0; f < far_exact.size(); ++f) {
      const LinkBody& body = pair.far->bodies[f];
      const Eigen::Isometry3d pose = links.at(body.link) * body.link_from_body;
      for (std::size_t n = 0; n < near_exact.size(); ++n) {
        const LinkBody& near = pair.near->bodies[n];
        if (near_exact[n].meets(far_exact[f], pose, links.at(near.link) * near.link_from_body)) return true;
      }
    }
    return false;
  }

  bool meetsNear(const Solid& solid, const Eigen::Isometry3d& pose,
                 const std::map<std::string, Eigen::Isometry3d>& links) const {
    const Extents extents = solid.extentsAt(pose, Point3::UnitZ());
    for (std::size_t i = 0; i < near_solids.size(); ++i) {
      const LinkBody& body = pair.near->bodies[i];
      const Eigen::Isometry3d near_pose = links.at(body.link) * body.link_from_body;
      if (near_solids[i].extentsAt(near_pose, Point3::UnitZ()).meets(extents) &&
          near_solids[i].meets(solid, pose, near_pose))
        return true;
    }
    return false;
  }
};

std::size_t CollisionTable::Cells::cellOf(const JointValues& values) const {
  const double from_low = values[joint] - low;
  const bool is_within = from_low >= 0.0 && from_low < kWholeTurn;  // as values within limits mostly are
  const double within = is_within ? from_low : from_low - kWholeTurn * std::floor(from_low / kWholeTurn);
  return std::min(count - 1, static_cast<std::size_t>(within / width));
}

CollisionTable::Cells CollisionTable::cellsOf(Eigen::Index index, const DrivenJoint& joint, double finest) {
  const double range = std::min(kWholeTurn, joint.high - joint.low);
  const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(range / finest)));
  const double low = std::isfinite(joint.low) ? joint.low : -M_PI;
  return {index, low, range / static_cast<double>(count), count};
}

CollisionTable::CollisionTable(const JointedPair& pair, const std::vector<DrivenJoint>& joints,
                               const PairPoses& poses)
    : columns_(cellsOf(pair.joints[0], joints[static_cast<std::size_t>(pair.joints[0])],
                       pair.hasOneJoint() ? kFinestOfOne : kFinest)),
      rows_(pair.hasOneJoint()
                ? oneCell(columns_)
                : cellsOf(pair.joints[1], joints[static_cast<std::size_t>(pair.joints[1])], kFinest)),
      cells_(columns_.count * rows_.count, false),
      text_("link " + namesOf(*pair.far) + " would be in link " + namesOf(*pair.near)) {
  Filling filling{*this, pair, poses, {}, {}, {}};
  const auto isMesh = [](const LinkBody& body) { return std::holds_alternative<MeshShape>(body.shape); };
  const auto hasMesh = [&](const RigidGroup& group) {
    return std::any_of(group.bodies.begin(), group.bodies.end(), isMesh);
  };
  if (hasMesh(*pair.near) || hasMesh(*pair.far)) {
    for (const LinkBody& body : pair.near->bodies) filling.near_exact.emplace_back(body.shape);
    for (const LinkBody& body : pair.far->bodies) filling.far_exact.emplace_back(body.shape);
  }
  for (const LinkBody& body : pair.near->bodies)
    filling.near_solids.emplace_back(isMesh(body) ? grown(body.shape, 0.0) : body.shape);
  filling.fill({0, columns_.count}, {0, rows_.count});
}

SelfCollisionGuard::SelfCollisionGuard(const KinematicModel& model, const LinkBodies& bodies) {
  const LinkTree tree(*parseMachine(model.urdf()));
  const std::vector<DrivenJoint>& joints = model.joints();
  for (const auto& [near, far] : bodies.pairs) {
    auto pair = jointedPair(bodies, near, far, joints);
    if (!pair) continue;
    const auto nameOf = [&](std::size_t i) { return joints[static_cast<std::size_t>(pair->joints[i])].name; };
    // How two groups stand to each other is a matter of the joints between them alone.
    const PairPoses poses = [&](double first, double second) {
      if (pair->hasOneJoint()) return tree.rootFromLinks({{nameOf(0), first}});
      return tree.rootFromLinks({{nameOf(0), first}, {nameOf(1), second}});
    };
    for (const auto& [near_part, far_part] : checkedParts(bodies, bodies.groups[near], bodies.groups[far])) {
      pair->near = &near_part;
      pair->far = &far_part;
      tables_.emplace_back(*pair, joints, poses);
    }
  }
}

SelfCollisionGuard::~SelfCollisionGuard() = default;

bool SelfCollisionGuard::allows(const JointValues& values) const {
  return std::none_of(tables_.begin(), tables_.end(),
                      [&](const CollisionTable& table) { return table.isBanned(values); });
}

std::string SelfCollisionGuard::hindrance(const JointValues& values) const {
  const auto banned = std::find_if(tables_.begin(), tables_.end(),
                                   [&](const CollisionTable& table) { return table.isBanned(values); });
  return banned == tables_.end() ? std::string() : banned->text();
}

}  // namespace lamina
