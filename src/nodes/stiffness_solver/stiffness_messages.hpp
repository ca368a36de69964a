// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "lamina/stiffness/stiffness.hpp"
#include "messages.hpp"

namespace lamina {

lamina_msgs::ComputeStiffnessResult toMessage(const StiffnessResult& result);

/// The nodes on the surface where they were before the load, in frame `bed`, with the fields
/// `displacement_x`, `_y`, `_z` [m] and `von_mises` [Pa].
sensor_msgs::PointCloud2 stiffnessCloud(const StiffnessResult& result);

}  // namespace lamina
