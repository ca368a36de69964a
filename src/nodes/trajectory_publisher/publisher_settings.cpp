// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "publisher_settings.hpp"

#include "lamina/trajectory/nozzle_motion.hpp"

namespace lamina {

void describe(SettingsSchema& schema, PublisherSettings& settings) {
  describe(schema, settings.machine, "Machine whose axes move.");
  schema.choice<TrajectoryMode>(
      "mode", settings.mode, {{"visualise", TrajectoryMode::Visualise}, {"follow", TrajectoryMode::Follow}},
      "Play the toolpath in time, or follow the machine's own reports.");
  schema.text("load_program", settings.load_program, "Program that is shown from the start; empty for none.");
  schema.number("program.filament_diameter_mm", settings.reading.filament_diameter_mm,
                Bounds::above(0.0, 20.0), "Diameter of the filament of programs that are loaded.");
  schema.number("program.flow", settings.reading.flow, Bounds::above(0.0, 10.0),
                "Factor on all extrusion of programs that are loaded.");
  schema.number("speed_up", settings.speed_up, Bounds::above(0.0, 1e4), "Factor on the speed of playing.");
  schema.number("rate_hz", settings.rate_hz, Bounds::above(0.0, 1000.0), "Positions a second while playing.");
  schema.number("cartesian.rate_hz", settings.cartesian_rate_hz, kNozzleRates,
                "States of the nozzle a second of its trajectory.");
  schema.number("path_spacing_mm", settings.path_spacing_mm, {0.0, 1e3},
                "Least distance between the poses of nozzle_path.");
  describe(schema, settings.run);
}

}  // namespace lamina
