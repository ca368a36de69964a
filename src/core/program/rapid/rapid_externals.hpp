// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/rapid/rapid_settings.hpp"

namespace lamina {

/// Name of a logical axis: "eax_a" of slot 0.
std::string rapidAxisName(std::size_t slot);

/// The axes of `rapid.external_axes` in the order of an arm's external joints; nothing if the setting is
/// empty.
/// @throws InvalidConfig naming the joint, if the arm does not have one that is named, or one of its own is
/// not
std::vector<RapidExternal> externalsOf(const KinematicModel& arm, const std::string& text);

}  // namespace lamina
