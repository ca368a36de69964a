// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/control/run/loop_run_settings.hpp"

namespace lamina {

/// Parameters of the node height_controller.
struct HeightControllerSettings {
  LoopRunSettings run;
  std::string output_folder;    ///< empty: nothing is saved
  double queue_mb = 400.0;      ///< memory of the clouds that may wait for tf [1e6 bytes]
  double arrival_hold_s = 0.2;  ///< real time for which tf waits for clouds sent with it
  std::string memory_file;      ///< state from which a restarted node continues; empty: none is kept
  bool pauses_print = true;     ///< whether an alarm may hold the print
  bool plans_followed = false;  ///< the executor follows plans by itself: plans do not hold the print
};

/// Adds the node's keys.
void describe(SettingsSchema& schema, HeightControllerSettings& settings);

/// Whether an alarm of the loop holds the print.
bool holdsPrint(const RaisedAlarm& alarm, const HeightControllerSettings& settings);

}  // namespace lamina
