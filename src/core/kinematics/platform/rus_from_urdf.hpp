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

/// As `rusDescriptionFromUrdf`, of a text that is read already.
/// @throws InvalidConfig as that
RusDescription rusDescription(const urdf::ModelInterface& model, const LinkTree& links);

/// The kinematic model of such a URDF.
/// @throws InvalidConfig as above
std::unique_ptr<KinematicModel> rusKinematicModel(const urdf::ModelInterface& model, const std::string& text);

}  // namespace lamina
