// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/process_io/process_bridge.hpp"

namespace lamina {

struct ProcessIoSettings {
  ProcessTableSettings tables;
  ProcessBridgeSettings bridge;
  double state_hz = 50.0;  ///< states published a second
};

/// Adds the keys devices, channels, inputs, rate_hz, late_s, too_late_s, standstill_s, connect_wait_s and
/// state_hz.
void describe(SettingsSchema& schema, ProcessIoSettings& settings);

}  // namespace lamina
