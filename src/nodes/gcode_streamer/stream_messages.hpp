// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <string>

#include "lamina/program/gcode/laid_filament.hpp"
#include "lamina/streaming/session/streamer.hpp"
#include "messages.hpp"

namespace lamina {

/// Temperatures and targets as the firmware reported them last, without stamp.
lamina_msgs::HeaterState toHeaterState(const StreamStatus& status);

/// @param job  file or toolpath being streamed; empty if none
/// @return the message without stamp
lamina_msgs::MachineState toMachineState(const StreamStatus& status, const std::string& job);

/// What is laid by the lines that the machine has accepted, and the feed of the last one while the job runs;
/// without stamp. Motions that wait in the machine's buffer count as done.
lamina_msgs::PrintProgress toPrintProgress(const StreamStatus& status, const LaidFilament& laid,
                                           const std::string& job);

lamina_msgs::StreamProgramFeedback toFeedback(const StreamStatus& status);

lamina_msgs::StreamProgramResult toResult(const StreamStatus& status, double duration_s);

/// The change that the service requests.
/// @param value  of feed, flow, rapid and spindle a fraction, of babystep [m]
/// @throws InvalidInput as `liveChange`
LiveChange liveChangeOf(const std::string& setting, double value);

/// OK, or a warning if lines had to be sent again or the firmware complained, or an error if the job failed.
void fillDiagnostics(const StreamStatus& status, diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace lamina
