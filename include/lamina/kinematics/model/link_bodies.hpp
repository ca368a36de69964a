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
  std::size_t parent = 0;          ///< index of the group that carries it
  std::string joint;               ///< joint between `parent` and the first of its links; empty at the root
};

/// The solid pieces of a machine, and which of them can collide.
struct LinkBodies {
  std::vector<RigidGroup> groups;
  std::size_t bed = 0;  ///< index of the group that carries the part
  /// Pairs of groups with links that can collide.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  /// Solid links that are built to touch, the parent first: links connected by one joint, or by several
  /// joints that turn about one point without solid pieces in between, as in a universal joint. Other links
  /// fixed to them can collide: for example a fence on the root of an arm with the arm's first link.
  std::vector<std::pair<std::string, std::string>> neighbours;
  /// Links that are not checked against each other, as the description says by
  /// `<lamina_ignore link1="" link2=""/>`.
  std::vector<std::pair<std::string, std::string>> ignored;
};

/// Whether two links, in either order, are neighbours or ignored, so that they are not checked against each
/// other.
bool areUnchecked(const LinkBodies& bodies, const std::string& a, const std::string& b);

/// Whether any two solid links of two groups are not checked against each other.
bool areUnchecked(const LinkBodies& bodies, const RigidGroup& a, const RigidGroup& b);

/// Links with solid pieces that move against each other and are never checked: first neighbours, then those
/// that the description ignores.
std::vector<std::pair<std::string, std::string>> uncheckedLinks(const LinkBodies& bodies);

/// The `<collision>` elements of a machine or robot, as `movingBodies` reads them, in the order of the tree:
/// parents before children, and these by their names.
/// @throws InvalidConfig if it is no URDF, has no link `bed` or ignores a link that it does not have; as
///   `movingBodies`
LinkBodies linkBodies(const std::string& urdf);

}  // namespace lamina
