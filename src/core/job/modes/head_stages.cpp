// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/head_stages.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"

namespace lamina {
namespace {

/// Round the tool axis [frame of the nozzle, whose z is along it].
HeadStage stageOf(const BodyShape& shape, const Eigen::Isometry3d& nozzle_from_body) {
  constexpr int kDirections = 64;
  const auto reach = [&](const Point3& direction) {
    return direction.dot(nozzle_from_body.translation()) +
           extent(shape, nozzle_from_body.linear().transpose() * direction);
  };
  HeadStage stage{-reach(Point3::UnitZ()), reach(-Point3::UnitZ()), 0.0};
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * M_PI * i / kDirections;
    stage.radius_mm = std::max(stage.radius_mm, reach({std::cos(angle), std::sin(angle), 0.0}));
  }
  return stage;
}

}  // namespace

std::vector<HeadStage> headStages(const MachineSettings& machine) {
  const std::unique_ptr<KinematicModel> model = kinematicModelOf(machine);
  const JointValues rest = JointValues::Zero(static_cast<Eigen::Index>(model->joints().size()));
  const std::map<std::string, Eigen::Isometry3d> places = model->bedFromLinks(rest);
  std::vector<HeadStage> stages;
  for (const RigidGroup& group : linkBodies(model->urdf()).groups) {
    if (std::find(group.links.begin(), group.links.end(), "nozzle") == group.links.end()) continue;
    for (const LinkBody& body : group.bodies)
      stages.push_back(
          stageOf(body.shape, places.at("nozzle").inverse() * places.at(body.link) * body.link_from_body));
  }
  return stages;
}

}  // namespace lamina
