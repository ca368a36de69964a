// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Transform.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

namespace lamina {

/// The transform of a message.
/// @return translation [mm]
Eigen::Isometry3d fromMessage(const geometry_msgs::Transform& transform);
/// The message of a transform.
/// @param transform  translation [mm]
geometry_msgs::Transform toTransformMessage(const Eigen::Isometry3d& transform);

/// A frame's name for tf2, without the leading slash that drivers from before tf2 write.
std::string bareFrame(const std::string& frame);

/// target_from_source at a time [mm]; nothing if tf does not know it.
/// @param source  with a leading slash or without
std::optional<Eigen::Isometry3d> lookUp(const tf2::BufferCore& buffer, const std::string& target,
                                        const std::string& source, const ros::Time& stamp);

/// Whether tf knows a transform at a time, or may still learn it.
enum class Readiness { Ready, NotYet, Never };
Readiness readiness(const tf2::BufferCore& buffer, const std::string& target, const std::string& source,
                    const ros::Time& stamp);

}  // namespace lamina
