// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// How a program is corrected while it is sent.
struct StreamCorrectionSettings {
  bool is_used = false;
  std::string folder;       ///< for the record of what was applied; empty for none
  LoopSettings loop;        ///< settings of waiting and feeding are used
  std::string calibration;  ///< file of results; empty for none
  /// Whether the remaining layers of a toolpath are replaced by a new plan, once there is one.
  bool follows_plans = false;
};

/// Adds the keys corrections.*, sensor.calibration, loop.wait_s and those that `describeFeeding` adds.
void describe(SettingsSchema& schema, StreamCorrectionSettings& settings);

}  // namespace lamina
