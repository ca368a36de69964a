// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

// Names of the linear axes in a machine's URDF.
inline constexpr const char* kAxisNames[] = {"x", "y", "z"};
inline constexpr const char* kRotaryNames[] = {"a", "b", "c"};

/// Parses the URDF of a machine.
/// @throws InvalidConfig with the first reason if the text is no URDF
std::shared_ptr<urdf::ModelInterface> parseMachine(const std::string& text);

/// A pose of URDF, converted from m to mm.
Eigen::Isometry3d poseOf(const urdf::Pose& pose);

/// The link of that name.
/// @throws InvalidConfig if there is none
const urdf::Link& requireLink(const urdf::ModelInterface& model, const std::string& link);

/// Axis of a joint [frame of its child link]. It must be of unit length, as another length would scale the
/// joint's values.
/// @throws InvalidConfig if it is not
Point3 directionOf(const urdf::ModelInterface& model, const urdf::Joint& joint);

/// Pose of a link over the machine's root with all joints at 0, and how the machine's axes move the link.
struct LinkMotion {
  Eigen::Isometry3d root_from_link = Eigen::Isometry3d::Identity();  ///< translation [mm]
  /// Columns: displacement in the root frame per mm of x, y and z.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  /// Those of the joints a, b and c that turn the link, the nearest one first.
  std::vector<std::string> rotaries;
};

/// How the machine's axes move a link.
/// @throws InvalidConfig if there is no such link, or a joint other than x, y, z, a, b and c moves it
LinkMotion motionOf(const urdf::ModelInterface& model, const std::string& link);

}  // namespace lamina
