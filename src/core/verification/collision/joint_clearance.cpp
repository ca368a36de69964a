// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/joint_clearance.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "verification/collision/deposited_boxes.hpp"
#include "verification/collision/deposited_tree.hpp"
#include "verification/collision/joint_places.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {
namespace {

constexpr std::size_t kStationsTogether = 256;  // looked at by one thread

using LinkPoses = std::map<std::string, Eigen::Isometry3d>;

/// A body where it is.
struct PlacedBody {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< [bed frame]
  Extents extents;
};

/// What there is to know of a collision at one place.
struct JointHit {
  const LinkBody* body = nullptr;
  Point3 middle = Point3::Zero();  ///< of the body
  const LinkBody* other = nullptr;
  std::size_t box = 0;  ///< of no meaning if there is another body
};

/// Checks the places of a machine or robot.
class JointClearanceCheck {
 public:
  JointClearanceCheck(const JointRun& run, const LinkBodies& bodies, const ClearanceSettings& settings)
      : run_(run),
        bodies_(bodies),
        settings_(settings),
        normal_(run.bed_from_part.linear() * layerNormal(run.toolpath)),
        deposited_(depositedBoxes(run.toolpath, run.bed_from_part, settings.tolerance_mm)),
        tree_(deposited_.boxes, normal_),
        deposited_before_(depositedBeforeStations(run, settings.tolerance_mm)) {
    for (const RigidGroup& group : bodies.groups) {
      solids_.emplace_back();
      for (const LinkBody& body : group.bodies) solids_.back().emplace_back(body.shape);
    }
  }

  std::optional<Collision> check(std::size_t station) const {
    for (const JointValues& values : placesBefore(run_, station, settings_))
      if (const std::optional<JointHit> hit = hitAt(values, deposited_before_[station]))
        return collisionOf(station, values, *hit);
    return std::nullopt;
  }

 private:
  using Placed = std::vector<std::vector<PlacedBody>>;  // by group

  Placed placed(const LinkPoses& links) const {
    Placed all(bodies_.groups.size());
    for (std::size_t g = 0; g < all.size(); ++g)
      for (std::size_t b = 0; b < bodies_.groups[g].bodies.size(); ++b) {
        const LinkBody& body = bodies_.groups[g].bodies[b];
        const Eigen::Isometry3d pose = links.at(body.link) * body.link_from_body;
        all[g].push_back({pose, solids_[g][b].extentsAt(pose, normal_)});
      }
    return all;
  }

  std::optional<JointHit> hitAt(const JointValues& values, std::size_t deposited) const {
    const Placed bodies = placed(run_.model.bedFromLinks(values));
    for (const auto& [a, b] : bodies_.pairs)
      if (std::optional<JointHit> hit = hitBetween(a, b, bodies)) return hit;
    for (std::size_t g = 0; g < bodies.size(); ++g)
      if (g != bodies_.bed)
        if (std::optional<JointHit> hit = hitInMaterial(g, bodies[g], deposited)) return hit;
    return std::nullopt;
  }

  std::optional<JointHit> hitBetween(std::size_t a, std::size_t b, const Placed& bodies) const {
    for (std::size_t i = 0; i < bodies[a].size(); ++i)
      for (std::size_t k = 0; k < bodies[b].size(); ++k) {
        const PlacedBody& one = bodies[a][i];
        const PlacedBody& other = bodies[b][k];
        if (!one.extents.meets(other.extents) || !solids_[a][i].meets(solids_[b][k], other.pose, one.pose))
          continue;
        // What carries the part is what is run into.
        if (a == bodies_.bed)
          return JointHit{&bodies_.groups[b].bodies[k], other.pose.translation(),
                          &bodies_.groups[a].bodies[i]};
        return JointHit{&bodies_.groups[a].bodies[i], one.pose.translation(), &bodies_.groups[b].bodies[k]};
      }
    return std::nullopt;
  }

  std::optional<JointHit> hitInMaterial(std::size_t group, const std::vector<PlacedBody>& bodies,
                                        std::size_t deposited) const {
    std::optional<JointHit> hit;
    for (std::size_t b = 0; b < bodies.size() && !hit; ++b)
      tree_.visitMeeting(bodies[b].extents, deposited, [&](std::size_t box, const Extents& of_box) {
        if (box >= deposited || !bodies[b].extents.meets(of_box) ||
            !solids_[group][b].meets(deposited_.boxes[box], bodies[b].pose))
          return false;
        hit = JointHit{&bodies_.groups[group].bodies[b], bodies[b].pose.translation(), nullptr, box};
        return true;
      });
    return hit;
  }

  Collision collisionOf(std::size_t station, const JointValues& values, const JointHit& hit) const {
    Collision collision;
    collision.at = run_.path.at[station];
    collision.tip = run_.model.bedFromNozzle(values).translation();
    collision.link = hit.body->link;
    if (hit.other == nullptr) {
      collision.obstacle = Obstacle::Material;
      collision.deposited = deposited_.boxes[hit.box].deposited;
      collision.place = deposited_.boxes[hit.box].middle;
    } else if (hit.other->link == "bed") {
      collision.obstacle = Obstacle::Bed;
      collision.place = {collision.tip.x(), collision.tip.y(), 0.0};
    } else {
      collision.obstacle = Obstacle::Machine;
      collision.other = hit.other->link;
      collision.place = hit.middle;
    }
    return collision;
  }

  const JointRun& run_;
  const LinkBodies& bodies_;
  ClearanceSettings settings_;
  Point3 normal_;
  DepositedBoxes deposited_;
  DepositedTree tree_;
  std::vector<std::size_t> deposited_before_;
  std::vector<std::vector<Solid>> solids_;  // as the bodies of the groups
};

bool hasMovingBodies(const LinkBodies& bodies) {
  for (std::size_t g = 0; g < bodies.groups.size(); ++g)
    if (g != bodies.bed && !bodies.groups[g].bodies.empty()) return true;
  return false;
}

}  // namespace

JointClearanceReport checkJointClearance(const JointRun& run, const LinkBodies& bodies,
                                         const ClearanceSettings& settings, Progress& progress) {
  if (!hasMovingBodies(bodies))
    throw InvalidConfig("machine '" + run.model.name() +
                        "' has no collision geometry on any link that moves against the bed; expected some "
                        "on its nozzle and head");
  const JointClearanceCheck check(run, bodies, settings);
  const std::size_t stations = run.path.at.size();
  std::vector<std::vector<Collision>> found((stations + kStationsTogether - 1) / kStationsTogether);
  parallelFor(
      found.size(),
      [&](std::size_t i) {
        const std::size_t end = std::min(stations, (i + 1) * kStationsTogether);
        for (std::size_t s = i * kStationsTogether; s < end; ++s)
          if (const std::optional<Collision> collision = check.check(s)) found[i].push_back(*collision);
      },
      progress, "clearance");
  JointClearanceReport report;
  for (const JointValues& values : run.path.values) report.waypoints += values.size() > 0 ? 1 : 0;
  for (const std::vector<Collision>& some : found)
    for (const Collision& collision : some)
      if (report.collisions.empty() || report.collisions.back().at != collision.at)
        report.collisions.push_back(collision);
  return report;
}

}  // namespace lamina
