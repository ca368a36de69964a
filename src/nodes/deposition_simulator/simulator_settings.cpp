// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulator_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, SimulationSettings& settings) {
  describe(schema, settings.deposition);
  schema.number("program.filament_diameter_mm", settings.reading.filament_diameter_mm,
                Bounds::above(0.0, 20.0), "Diameter of the filament of programs that are read.");
  schema.number("program.flow", settings.reading.flow, Bounds::above(0.0, 10.0),
                "Factor on all extrusion of programs that are read.");
  describe(schema, settings.reading.drops);
  describe(schema, settings.reading.five_axis);
  describe(schema, settings.machine, "Machine that five-axis programs were written for.");
}

void describe(SettingsSchema& schema, DepositionSimulatorSettings& settings) {
  schema.choice<SimulatorMode>(
      "mode", settings.mode, {{"simulate", SimulatorMode::Simulate}, {"follow", SimulatorMode::Follow}},
      "Lay only what is asked for, or also the toolpath that a machine runs, behind its nozzle.");
  describe(schema, settings.simulation);
  describe(schema, settings.following);
  schema.number("following.period_s", settings.period_s, {0.01, 3600.0},
                "Time between publications of what is deposited behind the nozzle.");
  schema.integer("shown.points", settings.shown.points, {1000, 100000000},
                 "Points of the cloud of what is deposited; coarser voxels are shown beyond it.");
  schema.integer("shown.triangles", settings.shown.triangles, {1000, 10000000},
                 "Triangles of the surface of what is deposited; coarser voxels are shown beyond it.");
}

}  // namespace lamina
