// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/process_io/devices/emulated_coupler.hpp"

namespace lamina {

struct EmulatedCouplerSettings {
  std::string bind = "127.0.0.1";
  int port = 1502;  ///< 0 for any that is free
  bool is_ready = true;
  CouplerSettings coupler;
};

/// Adds the keys bind, port, ready, watchdog_s, dead_time_s and lag_s.
void describe(SettingsSchema& schema, EmulatedCouplerSettings& settings);

}  // namespace lamina
