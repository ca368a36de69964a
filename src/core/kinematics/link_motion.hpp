// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <Eigen/Geometry>
#include <memory>
#include <string>

namespace lamina {

inline constexpr const char* kAxisNames[] = {"x", "y", "z"};  ///< joints of a machine's URDF

/// @throws InvalidConfig if the text is no URDF
std::shared_ptr<urdf::ModelInterface> parseMachine(const std::string& text);

/// A pose of URDF, in mm.
Eigen::Isometry3d poseOf(const urdf::Pose& pose);

/// A link over the machine's root, with all axes at 0, and how it moves with each axis.
struct LinkMotion {
  Eigen::Isometry3d root_from_link = Eigen::Isometry3d::Identity();  ///< translation [mm]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  ///< columns: root frame, per mm of x, y, z
};

/// @throws InvalidConfig if there is no such link, or it hangs on a joint that moves other than x, y and z
LinkMotion motionOf(const urdf::ModelInterface& model, const std::string& link);

}  // namespace lamina
