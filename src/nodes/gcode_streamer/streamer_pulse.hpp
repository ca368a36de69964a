// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/startup/startup_session.hpp"
#include "lamina/streaming/guard/machine_pulse.hpp"
#include "streamer_settings.hpp"

namespace lamina {

/// Data with which a watch can stop the machine in place of the node, except the file of the job.
/// @param job  state of the job under way; Idle if there is none
MachinePulse pulseOf(const GcodeStreamerSettings& settings, PackmlState job, const StreamStatus& status,
                     const StartupReport& startup);

}  // namespace lamina
