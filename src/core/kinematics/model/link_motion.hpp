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

// Joints of a machine's URDF.
inline constexpr const char* kAxisNames[] = {"x", "y", "z"};
inline constexpr const char* kRotaryNames[] = {"a", "b", "c"};

/// @throws InvalidConfig if the text is no URDF; gives the first reason
std::shared_ptr<urdf::ModelInterface> parseMachine(const std::string& text);

/// A pose of URDF, in mm.
Eigen::Isometry3d poseOf(const urdf::Pose& pose);

/// @throws InvalidConfig if there is no such link
const urdf::Link& requireLink(const urdf::ModelInterface& model, const std::string& link);

/// Axis of a joint, of unit length: any other would be a second scale beside the limits [frame of its child].
/// @throws InvalidConfig if it has another length
Point3 directionOf(const urdf::ModelInterface& model, const urdf::Joint& joint);

/// A link over the machine's root, with all joints at 0, and how it moves with each linear axis.
struct LinkMotion {
  Eigen::Isometry3d root_from_link = Eigen::Isometry3d::Identity();  ///< translation [mm]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  ///< columns: root frame, per mm of x, y, z
  std::vector<std::string> rotaries;               ///< joints a, b, c that turn it, its own first
};

/// @throws InvalidConfig if there is no such link, or it hangs on a joint that moves other than x, y, z, a, b
/// and c
LinkMotion motionOf(const urdf::ModelInterface& model, const std::string& link);

}  // namespace lamina
