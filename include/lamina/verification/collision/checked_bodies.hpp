// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"

namespace lamina {

/// Links that are built into each other: they meet with all joints at zero, or the limit nearest to it, and
/// in more than 95 % of 200 poses that are always the same, as far as the machine has them. Meshes of makers
/// do so that are convex hulls, as of the fork that holds the flange. What is fixed to the root and does not
/// carry the other link is never built in, as a bed or a fence: that stands in the way.
/// @param bodies  as `linkBodies` returns them; links that go unchecked by these are left out
std::vector<std::pair<std::string, std::string>> builtInLinks(const KinematicModel& model,
                                                              const LinkBodies& bodies);

/// The solid pieces of a machine, of which links that are built into each other are ignored as well.
/// @throws as `linkBodies`
LinkBodies checkedBodies(const KinematicModel& model);

}  // namespace lamina
