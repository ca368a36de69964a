// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Warning that robot_description describes another robot than the machine, with the names of both; empty if
/// it describes the machine.
/// @param present  URDF in robot_description
/// @param own      URDF of the machine
std::string descriptionWarning(const std::string& present, const std::string& own);

}  // namespace lamina
