// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "correction_settings.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/gcode_rewrite/dry_run.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/startup/startup_settings.hpp"
#include "lamina/streaming/session/stream_session.hpp"

namespace lamina {

struct GcodeStreamerSettings {
  MachinePort port{"/dev/ttyUSB0", 115200};
  MachineSettings machine;
  std::string owner;  ///< the only node whose orders are followed; empty for any node
  StreamSettings stream;
  ProgramSettings program;
  StartupSettings startup;
  StreamCorrectionSettings corrections;
  DryRunSettings dry;
  double owner_grace_s = 0.0;  ///< time without the ordering cell until the job is held; 0 for no limit
  std::string guard_socket;    ///< of the watch that stops the machine in this node's place; empty for none
};

/// Adds the keys port, baud, executor.owner, machine.*, stream.*, program.*, startup.*, corrections.*,
/// dry.*, owner.*, guard.* and some of loop.*.
void describe(SettingsSchema& schema, GcodeStreamerSettings& settings);

}  // namespace lamina
