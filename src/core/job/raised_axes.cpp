// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/raised_axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/orientation/kept_lean.hpp"

namespace lamina {
namespace {

/// How far what turns with the nozzle may lean before it is in the bed, a plane without end.
class HeadOverBed {
 public:
  /// @throws InvalidConfig as `linkBodies`
  explicit HeadOverBed(const KinematicModel& model);

  /// Greatest lean from upright, in whole degrees up to 120, at which, and below which, nothing of the head
  /// is deeper in the bed than the tolerance, wherever it leans to; 0 if it is at every lean.
  double greatestLeanDeg(double tip_mm, double tolerance_mm) const;

 private:
  std::vector<double>
      depth_mm_;  ///< by degree of lean: of the head below the tip, no less than at smaller leans
};

constexpr int kMostLeanDeg = 120;
constexpr int kHeadings = 32;

/// How far a body reaches from the nozzle tip in a direction [nozzle frame].
double reach(const LinkBody& body, const Eigen::Isometry3d& nozzle_from_body, const Point3& direction) {
  return direction.dot(nozzle_from_body.translation()) +
         extent(body.shape, nozzle_from_body.linear().transpose() * direction);
}

HeadOverBed::HeadOverBed(const KinematicModel& model) : depth_mm_(kMostLeanDeg + 1, 0.0) {
  const JointValues rest = JointValues::Zero(static_cast<Eigen::Index>(model.joints().size()));
  const std::map<std::string, Eigen::Isometry3d> places = model.bedFromLinks(rest);
  const Eigen::Isometry3d nozzle_from_bed = model.bedFromNozzle(rest).inverse();
  for (const RigidGroup& group : linkBodies(model.urdf()).groups) {
    if (std::find(group.links.begin(), group.links.end(), "nozzle") == group.links.end()) continue;
    for (const LinkBody& body : group.bodies) {
      const Eigen::Isometry3d place = nozzle_from_bed * places.at(body.link) * body.link_from_body;
      for (int lean = 0; lean <= kMostLeanDeg; ++lean)
        for (int heading = 0; heading < kHeadings; ++heading) {
          const double off_axis = toRadians(lean);
          const double about = 2.0 * M_PI * heading / kHeadings;
          const Point3 down(std::sin(off_axis) * std::cos(about), std::sin(off_axis) * std::sin(about),
                            std::cos(off_axis));
          double& depth = depth_mm_[static_cast<std::size_t>(lean)];
          depth = std::max(depth, reach(body, place, down));
        }
    }
  }
  for (std::size_t lean = 1; lean < depth_mm_.size(); ++lean)
    depth_mm_[lean] = std::max(depth_mm_[lean], depth_mm_[lean - 1]);
}

double HeadOverBed::greatestLeanDeg(double tip_mm, double tolerance_mm) const {
  const auto deeper = std::upper_bound(depth_mm_.begin(), depth_mm_.end(), tip_mm + tolerance_mm);
  return std::max(0.0, static_cast<double>(deeper - depth_mm_.begin()) - 1.0);
}

constexpr int kMostRaises = 8;    // rounds; a lean is gone after four
constexpr int kMostWithMore = 2;  // rounds in a row that leave more findings than one before

std::size_t findings(const RaisedToolpath& raised) {
  return raised.check.faults.size() + raised.check.collisions.size();
}

}  // namespace

RaisedToolpath raiseToolAxes(const Toolpath& wanted, const RaisingSite& site,
                             const std::function<MachineCheck(const Toolpath&)>& check, RaiseGoal goal) {
  RaiseLimits limits;
  limits.up = site.bed_from_part.linear().transpose() * Point3::UnitZ();
  limits.most_deg = site.settings.orientation.limits.max_off_normal_deg;
  KeptLean lean(wanted, limits);
  const HeadOverBed head(site.model);
  lean.limit([&](const Point3& tip) {
    return head.greatestLeanDeg((site.bed_from_part * tip).z(), site.settings.clearance.tolerance_mm);
  });
  const auto checked = [&](Toolpath toolpath) {
    MachineCheck found = check(toolpath);
    return RaisedToolpath{std::move(toolpath), std::move(found), lean.raised(), lean.least()};
  };
  RaisedToolpath raised = checked(lean.isChanged() ? lean.toolpath() : wanted);
  std::optional<RaisedToolpath> fewest;  // while the rounds after it leave more
  int more = 0;                          // of these
  for (int round = 0; round < kMostRaises && more < kMostWithMore && !raised.check.isClear(); ++round) {
    for (const Finding& finding : raised.check.faults) lean.raiseAt(finding.at);
    for (const Finding& finding : raised.check.collisions) lean.raiseAt(finding.at);
    if (!lean.isChanged()) break;
    RaisedToolpath further = checked(lean.toolpath());
    if (goal == RaiseGoal::Fewest) {
      more = findings(further) > findings(fewest ? *fewest : raised) ? more + 1 : 0;
      if (more == 0) fewest.reset();
      if (more == 1) fewest = std::move(raised);
    }
    raised = std::move(further);
  }
  return fewest ? *std::move(fewest) : raised;
}

std::string noteOnRaised(const RaisedToolpath& raised) {
  char text[260];
  std::snprintf(text, sizeof text,
                "at %zu waypoints the tool axis leans less than the layers ask, by up to %.0f %%, for the "
                "machine to run into nothing and its joints to stay within their limits",
                raised.waypoints, 100.0 * (1.0 - raised.least_kept));
  return text;
}

}  // namespace lamina
