// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/cooling/cooling_settings.hpp"

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "planning/cooling/fan_schedule.hpp"

namespace lamina {

void describe(SettingsSchema& schema, CoolingSettings& cooling) {
  schema.number("cooling.least_layer_time_s", cooling.least_layer_time_s, {0.0, 1e5},
                "Time that each layer takes at least; 0 for none.");
  schema.choice<CoolingBy>(
      "cooling.by", cooling.by,
      {{"slow_then_dwell", CoolingBy::SlowThenDwell}, {"slow", CoolingBy::Slow}, {"dwell", CoolingBy::Dwell}},
      "What makes a layer take that long.");
  schema.number("cooling.least_feed_mm_s", cooling.least_feed_mm_s, Bounds::above(0.0, 10000.0),
                "Slower than this nothing is deposited.");
  schema.number("cooling.lift_mm", cooling.lift_mm, {0.0, 1000.0}, "Lift of the nozzle while it waits.");
  schema.choice<ParkPlace>(
      "cooling.park", cooling.park,
      {{"outside", ParkPlace::Outside}, {"corner", ParkPlace::Corner}, {"stay", ParkPlace::Stay}},
      "Where the nozzle waits.");
  schema.choice<CoolingInterval>("cooling.interval", cooling.interval,
                                 {{"layer", CoolingInterval::Layer}, {"place", CoolingInterval::Place}},
                                 "What takes the least time: each layer, or the pause of each island between "
                                 "two layers.");
}

void describe(SettingsSchema& schema, FanSettings& fan) {
  schema.flag("fan.use", fan.is_used, "Whether the fan that cools the part is controlled.");
  schema.integer("fan.off_layers", fan.off_layers, {0, 100000}, "So many first layers without fan.");
  schema.number("fan.least", fan.least, {0.0, 1.0}, "Least share of the fan's power.");
  schema.number("fan.greatest", fan.greatest, {0.0, 1.0}, "Greatest share of the fan's power.");
  schema.number("fan.full_below_s", fan.full_below_s, {0.0, 1e5},
                "Layers of this time or less have the greatest share.");
  schema.number("fan.least_at_s", fan.least_at_s, {0.0, 1e5}, "Layers of this time have the least share.");
  schema.renamed("fan.off_above_s", "fan.least_at_s");
  schema.choice<FanSettings::WhenSlow>(
      "fan.beyond", fan.beyond,
      {{"least", FanSettings::WhenSlow::Least}, {"none", FanSettings::WhenSlow::None}},
      "What layers of more time have.");
  schema.number("fan.bridge", fan.bridge, {0.0, 1.0}, "Share while a bridge is deposited (bridges.use).");
  schema.number("fan.overhang", fan.overhang, {0.0, 1.0},
                "Share while walls are deposited that nothing carries (overhangs.use).");
  schema.text(
      "fan.by_role", fan.by_role,
      "Shares while roles are deposited, as support_interface=1,top_skin=0.8; others have that of the "
      "layer.");
  schema.number("fan.spin_up_s", fan.spin_up_s, {0.0, 60.0},
                "By how much the fan is commanded earlier to blow more.");
}

void requireConsistent(const FanSettings& fan) {
  if (fan.least > fan.greatest)
    throw InvalidConfig("fan.least is " + numberText(fan.least) + "; must be at most fan.greatest, " +
                        numberText(fan.greatest));
  if (fan.full_below_s > fan.least_at_s)
    throw InvalidConfig("fan.full_below_s is " + numberText(fan.full_below_s) +
                        " s; must be at most fan.least_at_s, " + numberText(fan.least_at_s) + " s");
  roleSharesOf(fan);
}

void requireConsistent(const CoolingSettings& cooling) {
  if (cooling.interval == CoolingInterval::Layer || cooling.by == CoolingBy::Dwell) return;
  throw InvalidConfig("cooling.interval is 'place' with cooling.by '" +
                      std::string(cooling.by == CoolingBy::Slow ? "slow" : "slow_then_dwell") +
                      "'; expected cooling.by 'dwell': no feed makes a place be left alone for longer");
}

}  // namespace lamina
