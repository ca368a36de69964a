// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/monitoring/height_monitor.hpp"

namespace lamina {

/// Parameters of the node layer_height_monitor.
struct LayerHeightMonitorSettings {
  MonitorSettings monitor;
  std::string output_folder;          ///< empty: nothing is saved
  std::string calibration;            ///< file of results; empty: stamps and tf as they are
  SettingTable other_time_offsets_s;  ///< of further sensors, by the frame of their clouds
  double silence_s = 30.0;    ///< real time without a profile after which a scan is given up; 0: never
  double map_period_s = 1.0;  ///< between publications of the maps, in real time
  double queue_mb = 400.0;    ///< memory of the clouds that may wait for tf [1e6 bytes]
};

/// Adds the node's keys.
void describe(SettingsSchema& schema, LayerHeightMonitorSettings& settings);

}  // namespace lamina
