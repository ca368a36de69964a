// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/loop_settings.hpp"

namespace lamina {
namespace {

void describeLaw(SettingsSchema& schema, LoopSettings& settings) {
  schema.choice("loop.process", settings.process,
                {{"free", LoopProcess::Free}, {"pressed", LoopProcess::Pressed}},
                "What sets the top of a bead: its volume, or the nozzle.");
  schema.number("loop.gain", settings.gain, Bounds::above(0.0, 1.9),
                "Share of the height error that a layer corrects.");
  schema.number("loop.learning", settings.learning, {0.0, 1.0},
                "Share of the growth measured that a layer learns.");
  schema.number("loop.low_pass_mm", settings.low_pass_mm, {0.01, 1000.0},
                "Standard deviation of the Gaussian by which corrections are smoothed along the bead.");
  schema.choice("loop.narrow_low_pass", settings.narrow_low_pass,
                {{"refused", NarrowLowPass::Refused}, {"raised", NarrowLowPass::Raised}},
                "What is done with a low-pass that is too narrow for the calibrations.");
  schema.number("loop.layer_volume", settings.layer_volume, Bounds::above(0.0, 10.0),
                "Greatest relative change of the volume of a whole layer.");
  schema.integer("loop.first_layers", settings.first_layers, {0.0, 1000.0},
                 "Layers that are learnt from and not corrected.");
  schema.number("loop.min_coverage", settings.min_coverage, {0.0, 1.0},
                "Share of a layer's cells that must be seen for it to count as measured.");
  schema.number("loop.growth_spread", settings.growth_spread, {0.01, 0.5},
                "Relative standard deviation of growth until it is learnt.");
  schema.number("loop.reading_correlation", settings.reading_correlation, {0.0, 1.0},
                "Correlation of neighbouring points of one profile.");
}

void describeMachine(SettingsSchema& schema, LoopSettings& settings) {
  schema.choice(
      "loop.z", settings.z,
      {{"plan", NozzleHeight::Plan}, {"layer", NozzleHeight::Layer}, {"surface", NozzleHeight::Surface}},
      "Height at which the nozzle runs.");
  schema.number("loop.trim", settings.trim, {0.0, 1.5},
                "Gain of a sensor behind the nozzle times its distance; 0 for none.");
  schema.number("loop.sensor_behind_mm", settings.sensor_behind_mm, {0.0, 1000.0},
                "Distance of that sensor behind the nozzle.");
  schema.number("loop.trim_lead_mm", settings.trim_lead_mm, {0.0, 1000.0},
                "Way ahead of the nozzle that is handed over before a trim can act.");
  schema.number("loop.speed_exponent", settings.speed_exponent, {-2.0, 0.0},
                "Power of the travel speed that growth goes with; 0 leaves the speed alone.");
  schema.number("loop.least_speed_mm_s", settings.least_speed_mm_s, {0.01, 1e5},
                "Least travel speed that a correction may ask for.");
  schema.number("loop.greatest_speed_mm_s", settings.greatest_speed_mm_s, {0.01, 1e5},
                "Greatest travel speed that a correction may ask for.");
  schema.number("loop.heat", settings.heat, {0.0, 1.0}, "Greatest relative change of the heat per length.");
}

void describeSupervision(SettingsSchema& schema, LoopSettings& settings) {
  schema.choice("loop.replan", settings.replan,
                {{"off", Replanning::Off},
                 {"hold", Replanning::Hold},
                 {"scale", Replanning::Scale},
                 {"add", Replanning::Add}},
                "What is done where corrections have come to their limits.");
  schema.choice("loop.on_loss", settings.on_loss, {{"hold", LossOfSight::Hold}, {"open", LossOfSight::Open}},
                "What is done after three layers without a measurement.");
  schema.number("loop.silence_s", settings.silence_s, Bounds::above(0.0, 3600.0),
                "Time without a cloud, within a scan, after which the sensor is lost.");
  schema.number("loop.wait_s", settings.wait_s, {0.0, 600.0},
                "Time that the start of a layer waits for its corrections.");
  schema.number("loop.alarm_layers", settings.alarm_layers, {0.1, 100.0},
                "Height error that raises an alarm, in layer heights.");
  schema.number("loop.part_learning", settings.part_learning, Bounds::above(0.0, 1.0),
                "Share of the height error that the next part corrects.");
}

}  // namespace

void describeFeeding(SettingsSchema& schema, LoopSettings& settings) {
  schema.number("loop.dead_time_s", settings.dead_time_s, {0.0, 60.0},
                "Time from a command until the feeder begins to follow.");
  schema.number("loop.lag_s", settings.lag_s, {0.0, 60.0}, "Time constant of the feeder.");
  schema.number("loop.feeder_rate_s", settings.feeder_rate_s, {0.001, 1000.0},
                "Greatest change of the relative amount per second.");
  schema.number("loop.least_amount", settings.least_amount, {-0.95, 0.0},
                "Least relative change of the amount deposited.");
  schema.number("loop.greatest_amount", settings.greatest_amount, {0.0, 5.0},
                "Greatest relative change of the amount deposited.");
}

void describe(SettingsSchema& schema, LoopSettings& settings) {
  describeLaw(schema, settings);
  describeFeeding(schema, settings);
  describeMachine(schema, settings);
  describeSupervision(schema, settings);
}

}  // namespace lamina
