// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings.hpp"
#include "lamina/monitoring/height_monitor.hpp"

namespace lamina {

/// Parameters of the node layer_height_monitor.
struct LayerHeightMonitorSettings {
  MonitorSettings monitor;
  std::string output_folder;  ///< empty: nothing is saved
  double quiet_s = 2.0;  ///< a scan that shows nothing new of its layer for that long is over, in real time
  double map_period_s = 1.0;  ///< between publications of the maps, in real time
  int queue = 20000;          ///< clouds
};

/// Adds the node's keys.
void describe(SettingsSchema& schema, LayerHeightMonitorSettings& settings);

}  // namespace lamina
