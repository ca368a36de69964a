// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "startup/startup_checks.hpp"

#include <cmath>

#include "startup/startup_code.hpp"

namespace lamina {
namespace {

Verdict verdictOf(bool is_met) { return is_met ? Verdict::Met : Verdict::NotMet; }

StartupCheck unknown(const std::string& what, const std::string& unit, const std::string& expected) {
  return {Verdict::Unknown,
          "the machine has not reported " + what + "; expected " + expected,
          {},
          unit,
          expected};
}

}  // namespace

StartupCheck checkBed(const MachineReports& reports, const StartupSettings& settings, Strictness strictness) {
  const double tolerance = settings.bed_tolerance_c * (strictness == Strictness::Keeping ? 2.0 : 1.0);
  const std::string expected = shortNumber(settings.bed_target_c - tolerance) + " to " +
                               shortNumber(settings.bed_target_c + tolerance) + " degC";
  const auto bed_c = reports.bed();
  if (!bed_c) return unknown("the bed's temperature", "degC", expected);
  return {verdictOf(std::abs(*bed_c - settings.bed_target_c) <= tolerance),
          "the bed is at " + shortNumber(*bed_c) + " degC; expected " + expected, bed_c, "degC", expected};
}

StartupCheck checkBedRate(const MachineReports& reports, const StartupSettings& settings) {
  const double rate = reports.fastestBed();
  const std::string expected = "at most " + shortNumber(settings.bed_max_rate_c_min) + " K/min";
  return {verdictOf(rate <= settings.bed_max_rate_c_min),
          "the bed heats at " + shortNumber(rate) + " K/min; expected " + expected, rate, "K/min", expected};
}

StartupCheck checkDrying(double dried_s, const StartupSettings& settings) {
  const double dried_h = dried_s / 3600.0;
  const std::string expected =
      "at least " + shortNumber(settings.dry_h) + " h at " + shortNumber(settings.dry_target_c) + " degC";
  return {verdictOf(dried_h >= settings.dry_h),
          "the pellets were dried for " + shortNumber(dried_h) + " h; expected " + expected, dried_h, "h",
          expected};
}

StartupCheck checkDryer(const MachineReports& reports, const StartupSettings& settings) {
  const double least = settings.dry_target_c - settings.dry_tolerance_c;
  const std::string expected = "at least " + shortNumber(least) + " degC";
  if (!reports.dryer()) return unknown("the dryer's temperature", "degC", expected);
  const double dryer_c = reports.dryer()->value_c;
  return {verdictOf(dryer_c >= least),
          "the dryer is at " + shortNumber(dryer_c) + " degC; expected " + expected, dryer_c, "degC",
          expected};
}

StartupCheck checkHomed(char axis, const MachineReports& reports) {
  const std::string expected = std::string(1, axis) + " among the homed axes";
  if (!reports.homed()) return unknown("which axes are homed", "", expected);
  const std::string letters = reports.homed()->empty() ? "none" : *reports.homed();
  return {verdictOf(letters.find(axis) != std::string::npos),
          "homed: " + letters + "; expected " + expected,
          {},
          "",
          expected};
}

StartupCheck checkVacuum(const MachineReports& reports, const StartupSettings& settings) {
  const std::string expected = "under " + shortNumber(settings.vacuum_max_kpa) + " kPa";
  StartupCheck worst{Verdict::Met, "", {}, "kPa", expected};
  for (const int zone : vacuumZones(settings)) {
    const auto found = reports.zones().find(zone);
    const std::string name = "zone " + std::to_string(zone);
    if (found == reports.zones().end()) return unknown("the pressure of " + name, "kPa", expected);
    if (worst.value && found->second <= *worst.value) continue;
    worst.value = found->second;
    worst.verdict = verdictOf(found->second < settings.vacuum_max_kpa);
    worst.reason = name + " is at " + shortNumber(found->second) + " kPa; expected " + expected;
  }
  return worst;
}

StartupCheck checkHeights(const MachineReports& reports, const StartupSettings& settings) {
  const std::string expected = "at most " + shortNumber(settings.map_flat_mm) + " mm";
  const auto& heights = reports.heights();
  if (!heights) return unknown("a height map", "mm", expected);
  const double range = heights->high_mm - heights->low_mm;
  return {verdictOf(range <= settings.map_flat_mm),
          "the bed's " + std::to_string(heights->points) + " heights differ by " + shortNumber(range) +
              " mm; expected " + expected,
          range, "mm", expected};
}

}  // namespace lamina
