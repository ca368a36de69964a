// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup_settings.hpp"

#include <algorithm>
#include <charconv>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

void describeSequence(SettingsSchema& schema, StartupSettings& settings) {
  std::string names;
  for (const StartupStep step : allStartupSteps())
    names += std::string(names.empty() ? "" : " ") + toString(step);
  schema.text(
      "startup.sequence", settings.sequence,
      "Steps before a job may start, in order, separated by blanks; empty for none. Known: " + names + ".");
  schema.text("startup.skip", settings.skip, "Steps of the sequence that need not be done.");
  for (const StartupStep step : allStartupSteps())
    schema.text(std::string("startup.after_") + toString(step),
                settings.after[static_cast<std::size_t>(step)],
                std::string("Further steps that ") + toString(step) + " must wait for.");
  schema.number("startup.speed_up", settings.speed_up, Bounds::above(0.0, 1000.0),
                "Machine time per wall time, as emulator.speed_up; 1 for a real machine.");
  schema.number("startup.check_interval_s", settings.check_interval_s, Bounds::above(0.0, 3600.0),
                "Wall time between two looks at the machine while no job is under way.");
  schema.text("startup.check_code", settings.check_code,
              "G-code that makes the machine report its condition.");
  schema.text("startup.abort_code", settings.abort_code,
              "G-code that leaves the machine safe when the sequence is aborted.");
}

void describeDrying(SettingsSchema& schema, StartupSettings& settings) {
  schema.text("startup.dry_code", settings.dry_code,
              "G-code that switches the dryer on; empty if the operator does and confirms it. {target_c} is "
              "replaced.");
  schema.text("startup.dry_label", settings.dry_label,
              "Text before the dryer's temperature in reports; empty if it is not reported.");
  schema.number("startup.dry_target_c", settings.dry_target_c, Bounds::above(0.0, 300.0),
                "Temperature of drying.");
  schema.number("startup.dry_tolerance_c", settings.dry_tolerance_c, {0.0, 100.0},
                "How far below the target still counts as drying.");
  schema.number("startup.dry_h", settings.dry_h, Bounds::above(0.0, 1000.0), "Time of drying.");
  schema.number("startup.dry_valid_h", settings.dry_valid_h, Bounds::above(0.0, 10000.0),
                "Time after which pellets not known to be kept dry must be dried again.");
}

void describeBed(SettingsSchema& schema, StartupSettings& settings) {
  schema.text("startup.bed_code", settings.bed_code,
              "G-code that sets the bed's target; empty if the operator heats it and confirms. {target_c} is "
              "replaced.");
  schema.number("startup.bed_target_c", settings.bed_target_c, Bounds::above(0.0, 150.0),
                "Temperature of the bed.");
  schema.number("startup.bed_tolerance_c", settings.bed_tolerance_c, Bounds::above(0.0, 50.0),
                "How far from the target the bed counts as hot.");
  schema.number("startup.bed_rate_c_min", settings.bed_rate_c_min, Bounds::above(0.0, 600.0),
                "Rate at which the bed's target is raised.");
  schema.number("startup.bed_max_rate_c_min", settings.bed_max_rate_c_min, Bounds::above(0.0, 6000.0),
                "Fastest the bed may be seen to heat.");
  schema.number("startup.bed_timeout_min", settings.bed_timeout_min, Bounds::above(0.0, 1440.0),
                "Time within which the bed must be hot.");
}

void describeAxes(SettingsSchema& schema, StartupSettings& settings) {
  schema.text("startup.home_code", settings.home_code,
              "G-code that homes an axis; empty if the operator does and confirms it. {axis} is replaced.");
  schema.text("startup.home_label", settings.home_label,
              "Text before the letters of the homed axes in reports; empty if they are not reported.");
  schema.text("startup.map_code", settings.map_code, "G-code that takes the height map and prints it.");
  schema.number("startup.map_flat_mm", settings.map_flat_mm, Bounds::above(0.0, 100.0),
                "Most that the highest point may be above the lowest.");
  schema.number("startup.map_valid_h", settings.map_valid_h, Bounds::above(0.0, 10000.0),
                "Time after which the height map must be taken again.");
}

void describeVacuum(SettingsSchema& schema, StartupSettings& settings) {
  schema.text("startup.vacuum_zones", settings.vacuum_zones, "Zones that must hold the sheet, by number.");
  schema.text("startup.vacuum_on_code", settings.vacuum_on_code,
              "G-code that opens a zone; empty if the operator does and confirms it. {zone} is replaced.");
  schema.text("startup.vacuum_off_code", settings.vacuum_off_code,
              "G-code that closes a zone. {zone} is replaced.");
  schema.text("startup.vacuum_label", settings.vacuum_label,
              "Text before a zone's pressure [kPa] in reports. {zone} is replaced.");
  schema.number("startup.vacuum_max_kpa", settings.vacuum_max_kpa, Bounds::above(0.0, 101.0),
                "Absolute pressure that every zone must stay under.");
  schema.number("startup.vacuum_evacuate_s", settings.vacuum_evacuate_s, {0.0, 3600.0},
                "Time until the pressure must be reached.");
  schema.number("startup.vacuum_hold_s", settings.vacuum_hold_s, {0.0, 3600.0},
                "Time over which it must be held.");
}

}  // namespace

void describe(SettingsSchema& schema, StartupSettings& settings) {
  describeSequence(schema, settings);
  describeDrying(schema, settings);
  describeBed(schema, settings);
  describeAxes(schema, settings);
  describeVacuum(schema, settings);
}

std::vector<int> vacuumZones(const StartupSettings& settings) {
  std::vector<int> zones;
  for (const std::string& word : splitIntoWords(settings.vacuum_zones)) {
    int zone = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), zone);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size())
      throw InvalidConfig("startup.vacuum_zones has '" + word + "'; expected numbers of zones");
    if (std::find(zones.begin(), zones.end(), zone) != zones.end())
      throw InvalidConfig("startup.vacuum_zones has zone " + word + " twice; expected each once");
    zones.push_back(zone);
  }
  if (zones.empty()) throw InvalidConfig("startup.vacuum_zones is empty; expected numbers of zones");
  return zones;
}

}  // namespace lamina
