// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <string>

#include "lamina/servo/servoj_drive.hpp"

namespace lamina {

/// The link to the robot: OK, or an error without a connection or after a motion that has ended early.
/// @param connection  why there is none, in words; empty if there is one
/// @param rights      `ServojDrive::rights`
void fillDiagnostics(const ServojDriveState& state, const std::string& connection, const std::string& rights,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace lamina
