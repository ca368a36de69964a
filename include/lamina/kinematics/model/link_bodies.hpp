// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

#include "lamina/kinematics/cartesian/machine_bodies.hpp"

namespace lamina {

/// A solid piece of a link.
struct LinkBody {
  std::string link;
  BodyShape shape;
  Eigen::Isometry3d link_from_body = Eigen::Isometry3d::Identity();  ///< [mm]
};

/// Links that never move against each other.
struct RigidGroup {
  std::vector<std::string> links;  ///< parents before children
  std::vector<LinkBody> bodies;    ///< of all of them
  std::size_t parent = 0;          ///< the group that it hangs on
  std::string joint;               ///< by which the first of its links hangs there; none at the root
};

/// The solid pieces of a machine, and which of them can run into each other.
struct LinkBodies {
  std::vector<RigidGroup> groups;
  std::size_t bed = 0;  ///< the group that carries the part
  /// Groups that can meet: all but those that hang on each other by one joint, or by several that turn about
  /// one point with nothing solid between them, as a universal joint does. They are built to touch.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

/// The `<collision>` elements of a machine or robot, as `movingBodies` reads them, in the order of the tree:
/// parents before children, and these by their names.
/// @throws InvalidConfig if it is no URDF or has no link `bed`; as `movingBodies`
LinkBodies linkBodies(const std::string& urdf);

}  // namespace lamina
