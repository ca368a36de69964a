// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "monitor_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, LayerHeightMonitorSettings& settings) {
  describe(schema, settings.monitor);
  schema.text("output_folder", settings.output_folder,
              "Where maps and heights are saved; empty saves nothing.");
  schema.text(
      "sensor.calibration", settings.calibration,
      "File that `lamina calibrate` wrote, for when and from where the sensor sees; empty: stamps and tf "
      "are as they are.");
  schema.table("sensor.other_time_offsets_s", settings.other_time_offsets_s,
               "Stamps of clouds of further sensors less the times at which they were taken, by the frame of "
               "the clouds.");
  schema.number("silence_s", settings.silence_s, {0.0, 3600.0},
                "A scan is given up when no profile has come for that long, in real time; 0: never.");
  schema.number("map_period_s", settings.map_period_s, Bounds::above(0.0, 3600.0),
                "Time between publications of the maps, in real time.");
  schema.number("queue_mb", settings.queue_mb, Bounds::above(0.0, 1e6),
                "Memory of the clouds that may wait for tf; with more, the oldest are pushed out.");
}

}  // namespace lamina
