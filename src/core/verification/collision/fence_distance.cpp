// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/fence_distance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "verification/collision/solid.hpp"

namespace lamina {
namespace {

constexpr const char* kFences = "cell_bodies";  // link of a cell's bodies

/// A piece of a link and a fence.
struct FencedPiece {
  const LinkBody* piece = nullptr;
  const LinkBody* fence = nullptr;
  std::size_t solid = 0;        ///< of the piece
  std::size_t fence_index = 0;  ///< in the cell file
  double farthest_mm = 0.0;     ///< of the piece, from its origin
  double at_least_mm = 0.0;     ///< how far apart they are at least, by the last look and what moved since
  Eigen::Isometry3d fence_from_piece = Eigen::Isometry3d::Identity();
};

/// Looks at places one after the other. Where a piece cannot have come nearer than the nearest so far, by
/// what it has moved since it was looked at, it is not looked at.
class FenceLook {
 public:
  FenceLook(const KinematicModel& model, const LinkBodies& bodies) : model_(model) {
    std::vector<const LinkBody*> fences;
    for (const RigidGroup& group : bodies.groups)
      for (const LinkBody& body : group.bodies)
        if (body.link == kFences) fences.push_back(&body);
    for (const LinkBody* fence : fences) fence_solids_.emplace_back(fence->shape);
    for (const RigidGroup& group : bodies.groups) {
      const bool stands = std::any_of(group.bodies.begin(), group.bodies.end(),
                                      [](const LinkBody& body) { return body.link == kFences; });
      if (stands || fences.empty()) continue;
      for (const LinkBody& body : group.bodies) {
        if (areUnchecked(bodies, body.link, kFences)) continue;
        for (std::size_t f = 0; f < fences.size(); ++f)
          pieces_.push_back({&body, fences[f], solids_.size(), f, boundingRadius(body.shape)});
        solids_.emplace_back(body.shape);
      }
    }
  }

  bool isOfNoUse() const { return pieces_.empty(); }

  void at(const JointValues& values, const WaypointIndex& at) {
    if (values.size() == 0) return;
    const auto links = model_.bedFromLinks(values);
    for (FencedPiece& each : pieces_) {
      const Eigen::Isometry3d pose = (links.at(each.fence->link) * each.fence->link_from_body).inverse() *
                                     links.at(each.piece->link) * each.piece->link_from_body;
      each.at_least_mm -= moved(each, pose);
      each.fence_from_piece = pose;
      if (each.at_least_mm >= nearest_.distance_mm) continue;
      each.at_least_mm = fence_solids_[each.fence_index].distanceTo(solids_[each.solid], pose,
                                                                    Eigen::Isometry3d::Identity());
      if (each.at_least_mm < nearest_.distance_mm)
        nearest_ = {each.at_least_mm, each.piece->link, each.fence_index, at};
    }
  }

  std::optional<FenceDistance> take() && {
    if (nearest_.link.empty()) return std::nullopt;
    return std::move(nearest_);
  }

 private:
  /// At most, of any point of the piece.
  static double moved(const FencedPiece& piece, const Eigen::Isometry3d& pose) {
    const Eigen::Matrix3d turned = pose.linear() - piece.fence_from_piece.linear();
    return (pose.translation() - piece.fence_from_piece.translation()).norm() +
           turned.norm() * piece.farthest_mm;
  }

  const KinematicModel& model_;
  std::vector<Solid> solids_;
  std::vector<Solid> fence_solids_;
  std::vector<FencedPiece> pieces_;
  FenceDistance nearest_{std::numeric_limits<double>::infinity(), {}, 0, {}};
};

}  // namespace

std::optional<FenceDistance> nearestToFences(const JointRun& run, const std::vector<JointPassage>& passages,
                                             const LinkBodies& bodies) {
  FenceLook look(run.model, bodies);
  if (look.isOfNoUse() || run.path.at.empty()) return std::nullopt;
  for (std::size_t i = 0; i < run.path.at.size(); ++i) look.at(run.path.values[i], run.path.at[i]);
  for (const JointPassage& passage : passages)
    for (const JointValues& values : passage.values)
      look.at(values, run.path.at[std::min(passage.before, run.path.at.size() - 1)]);
  return std::move(look).take();
}

}  // namespace lamina
