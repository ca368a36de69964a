// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/joint_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"
#include "verification/collision/deposited_boxes.hpp"
#include "verification/collision/deposited_tree.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {
namespace {

constexpr double kFreshWidths = 1.5;  // of the bead: what the nozzle has just left is soft, and has its shape
constexpr double kJointTurn = toRadians(5.0);  // of a joint between places

/// Boxes that are set once the nozzle has gone so far.
struct Fresh {
  double set_at_mm = 0.0;
  std::size_t boxes = 0;
};

double greatestTurn(const JointRun& run, const JointValues& from, const JointValues& to) {
  double greatest = 0.0;
  const std::vector<DrivenJoint>& joints = run.model.joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    if (joints[j].kind == JointKind::Rotary) greatest = std::max(greatest, std::abs(to[i] - from[i]));
  }
  return greatest;
}

/// How many boxes (`depositedBoxes`) are there when the nozzle sets out for each station of a joint path.
/// What it has deposited within the last one and a half bead widths of its way is soft still and no obstacle.
/// Goes the way of the whole toolpath, from station to station.
class Deposition {
 public:
  Deposition(const JointRun& run, double tolerance_mm)
      : stations_(run.path.at), tolerance_mm_(tolerance_mm), before_(run.path.at.size()) {
    const std::vector<ToolpathLayer>& layers = run.toolpath.layers;
    for (std::size_t l = 0; l < layers.size(); ++l)
      for (std::size_t p = 0; p < layers[l].paths.size(); ++p) lay(layers[l].paths[p], {l, p, 0});
  }

  /// Behind the last the number when it is reached.
  std::vector<std::size_t> beforeStations() && {
    before_.push_back(set_);
    return std::move(before_);
  }

 private:
  void lay(const Path& path, WaypointIndex at) {
    setOutFor(at);
    if (!path.is_closed) deposit(path, 0);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      at.waypoint = path.motionEnd(m);
      setOutFor(at);
      way_mm_ += (path.points[at.waypoint] - path.points[m]).norm();
      deposit(path, at.waypoint);
    }
  }

  void setOutFor(const WaypointIndex& at) {
    while (!fresh_.empty() && fresh_.front().set_at_mm <= way_mm_) {
      set_ = fresh_.front().boxes;
      fresh_.pop_front();
    }
    if (next_ < stations_.size() && stations_[next_] == at) before_[next_++] = set_;
  }

  void deposit(const Path& path, std::size_t waypoint) {
    all_ += piecesDepositedAt(path, waypoint, tolerance_mm_);
    fresh_.push_back({way_mm_ + kFreshWidths * path.bead.at(waypoint).width_mm, all_});
  }

  const std::vector<WaypointIndex>& stations_;
  double tolerance_mm_;
  std::vector<std::size_t> before_;
  std::deque<Fresh> fresh_;
  std::size_t next_ = 0;  // station
  std::size_t set_ = 0;   // boxes
  std::size_t all_ = 0;
  double way_mm_ = 0.0;
};

/// Whether no layer that has paths is left out between a station and the one before.
bool followsPrevious(const JointRun& run, std::size_t station) {
  if (station == 0) return false;
  const std::vector<ToolpathLayer>& layers = run.toolpath.layers;
  for (std::size_t l = run.path.at[station - 1].layer + 1; l < run.path.at[station].layer; ++l)
    if (!layers[l].paths.empty()) return false;
  return true;
}

/// Joint values at which to look between two, the second last.
std::vector<JointValues> placesBetween(const JointRun& run, const JointValues& from, const JointValues& to,
                                       const ClearanceSettings& settings) {
  const double way =
      (run.model.bedFromNozzle(to).translation() - run.model.bedFromNozzle(from).translation()).norm();
  const int steps = std::max({1, static_cast<int>(std::ceil(way / settings.spacing_mm)),
                              static_cast<int>(std::ceil(greatestTurn(run, from, to) / kJointTurn))});
  std::vector<JointValues> places;
  for (int i = 1; i < steps; ++i) places.push_back(from + static_cast<double>(i) / steps * (to - from));
  places.push_back(to);
  return places;
}

/// Joint values at which to look on the way to a station, the station last: the station alone if the joint
/// path does not go on there, or the one before has no values; nothing if it has none itself.
std::vector<JointValues> placesBefore(const JointRun& run, std::size_t station,
                                      const ClearanceSettings& settings) {
  const JointValues& to = run.path.values[station];
  if (to.size() == 0) return {};
  if (!followsPrevious(run, station) || run.path.values[station - 1].size() == 0) return {to};
  return placesBetween(run, run.path.values[station - 1], to, settings);
}

constexpr std::size_t kStationsTogether = 256;  // looked at by one thread

using LinkPoses = std::map<std::string, Eigen::Isometry3d>;

/// A body where it is.
struct PlacedBody {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< [bed frame]
  Extents extents;
  TurnedBox box;

  bool meets(const Extents& other) const { return extents.meets(other) && box.meets(other.box); }
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
        deposited_before_(Deposition(run, settings.tolerance_mm).beforeStations()) {
    for (const RigidGroup& group : bodies.groups) {
      solids_.emplace_back();
      for (const LinkBody& body : group.bodies) solids_.back().emplace_back(body.shape);
    }
  }

  std::optional<Collision> check(std::size_t station) const {
    for (const JointValues& values : placesBefore(run_, station, settings_))
      if (const std::optional<JointHit> hit = hitAt(values, deposited_before_[station]))
        return collisionOf(run_.path.at[station], values, *hit);
    return std::nullopt;
  }

  /// On the way to one of the values of a passage.
  std::optional<Collision> check(const JointPassage& passage, std::size_t index) const {
    const JointValues& to = passage.values[index];
    if (to.size() == 0) return std::nullopt;
    const bool is_led = index > 0 && passage.values[index - 1].size() > 0;
    const std::vector<JointValues> places =
        is_led ? placesBetween(run_, passage.values[index - 1], to, settings_) : std::vector<JointValues>{to};
    const std::size_t at = std::min(passage.before, run_.path.at.size() - 1);
    for (const JointValues& values : places)
      if (const std::optional<JointHit> hit = hitAt(values, deposited_before_[passage.before]))
        return collisionOf(run_.path.at[at], values, *hit);
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
        all[g].push_back({pose, solids_[g][b].extentsAt(pose, normal_), solids_[g][b].boxAt(pose)});
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
        if (areUnchecked(bodies_, bodies_.groups[a].bodies[i].link, bodies_.groups[b].bodies[k].link))
          continue;
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
      tree_.visitMeeting(bodies[b], deposited, [&](std::size_t box, const Extents&) {
        if (!solids_[group][b].meets(deposited_.boxes[box], bodies[b].pose)) return false;
        hit = JointHit{&bodies_.groups[group].bodies[b], bodies[b].pose.translation(), nullptr, box};
        return true;
      });
    return hit;
  }

  Collision collisionOf(const WaypointIndex& at, const JointValues& values, const JointHit& hit) const {
    Collision collision;
    collision.at = at;
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

void requireMovingBodies(const JointRun& run, const LinkBodies& bodies) {
  if (!hasMovingBodies(bodies))
    throw InvalidConfig("machine '" + run.model.name() +
                        "' has no collision geometry on any link that moves against the bed; expected some "
                        "on its nozzle and head");
}

}  // namespace

JointClearanceReport checkJointClearance(const JointRun& run, const LinkBodies& bodies,
                                         const ClearanceSettings& settings, Progress& progress) {
  requireMovingBodies(run, bodies);
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

std::vector<PassageCollision> checkJointPassages(const JointRun& run,
                                                 const std::vector<JointPassage>& passages,
                                                 const LinkBodies& bodies,
                                                 const ClearanceSettings& settings) {
  if (passages.empty() || run.path.at.empty()) return {};
  requireMovingBodies(run, bodies);
  const JointClearanceCheck check(run, bodies, settings);
  std::vector<PassageCollision> found;
  for (std::size_t p = 0; p < passages.size(); ++p)
    for (std::size_t i = 0; i < passages[p].values.size(); ++i)
      if (std::optional<Collision> collision = check.check(passages[p], i))
        found.push_back({p, i, *std::move(collision)});
  return found;
}

}  // namespace lamina
