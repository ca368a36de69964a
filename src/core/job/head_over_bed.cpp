// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/head_over_bed.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

#include "lamina/base/angle.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"

namespace lamina {
namespace {

constexpr int kMostLeanDeg = 120;
constexpr int kHeadings = 32;

/// How far a body reaches from the nozzle tip in a direction [nozzle frame].
double reach(const LinkBody& body, const Eigen::Isometry3d& nozzle_from_body, const Point3& direction) {
  return direction.dot(nozzle_from_body.translation()) +
         extent(body.shape, nozzle_from_body.linear().transpose() * direction);
}

}  // namespace

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

}  // namespace lamina
