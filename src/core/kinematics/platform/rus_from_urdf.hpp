// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <memory>
#include <string>

#include "kinematics/model/link_tree.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/platform/rus_description.hpp"

namespace lamina {

/// The description of a platform, as by `rusDescriptionFromUrdf`, from a parsed URDF.
/// @throws InvalidConfig as `rusDescriptionFromUrdf`
RusDescription rusDescription(const urdf::ModelInterface& model, const LinkTree& links);

/// The kinematic model of a platform, from its parsed URDF and its text.
/// @throws InvalidConfig as `rusDescriptionFromUrdf`
std::unique_ptr<KinematicModel> rusKinematicModel(const urdf::ModelInterface& model, const std::string& text);

}  // namespace lamina
