// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "drive_session.hpp"
#include "messages.hpp"

namespace lamina {

lamina_msgs::DriveToolpathFeedback toFeedback(const DriveStatus& status);
lamina_msgs::DriveToolpathResult toResult(const DriveStatus& status);
/// Without header.
lamina_msgs::MachineState toMachineState(const DriveStatus& status, const std::string& job);
/// Without header.
lamina_msgs::PrintProgress toPrintProgress(const DriveStatus& status, const std::string& job);
lamina_msgs::TrackingError toTrackingError(const DriveStatus& status, const KinematicModel& model);
/// ERROR if the job failed, WARN if the controller was starved.
void fillDiagnostics(const DriveStatus& status, diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace lamina
