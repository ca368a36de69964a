// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/runs/bead_run_settings.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/toolpath/process_levels.hpp"
#include "planning/runs/level_rules.hpp"

namespace lamina {
namespace {

constexpr double kMostWavesOfSwing = 2.0;  // wavelengths in an amplitude: beyond, no joint follows
constexpr std::string_view kFromBead = "from_bead";

void describeLead(SettingsSchema& schema, LeadSettings& lead) {
  const std::vector<std::pair<std::string, LeadShape>> shapes = {{"none", LeadShape::None},
                                                                 {"line", LeadShape::Line},
                                                                 {"arc", LeadShape::Arc},
                                                                 {"loop", LeadShape::Loop}};
  schema.choice<LeadShape>("lead.in", lead.in, shapes, "Way that leads to the beads of each run.");
  schema.choice<LeadShape>("lead.out", lead.out, shapes, "Way that leads on from the beads of each run.");
  schema.number("lead.length_mm", lead.length_mm, Bounds::above(0.0, 1000.0), "Length of a straight lead.");
  schema.number("lead.angle_deg", lead.angle_deg, {0.0, 90.0},
                "Angle of a straight lead to the bead's tangent, in the layer, on the free side.");
  schema.number("lead.rise_deg", lead.rise_deg, {0.0, 80.0}, "Rise of a lead out of the layer.");
  schema.number("lead.radius_mm", lead.radius_mm, Bounds::above(0.0, 1000.0),
                "Radius of a lead that is an arc or a loop.");
  schema.number("lead.sweep_deg", lead.sweep_deg, Bounds::above(0.0, 180.0),
                "Sweep of a lead that is an arc.");
  schema.number("lead.least_mm", lead.least_mm, Bounds::above(0.0, 1000.0),
                "Leads for which there is less room are left out; longer ones are shortened.");
  schema.choice<LeadDeposit>(
      "lead.process", lead.deposit,
      {{"dry", LeadDeposit::Dry}, {"bead", LeadDeposit::Bead}, {"ramp", LeadDeposit::Ramp}},
      "Whether leads lay nothing, the run's bead, or one that grows to it and fades from it.");
  schema.number("lead.overlap_mm", lead.overlap_mm, {-10.0, 1000.0},
                "By how much a closed run goes on over its start, where the bead grows as it fades at the "
                "end; negative ends it so much before its start.");
}

void describeLevels(SettingsSchema& schema, LevelSettings& levels) {
  schema.text(
      "levels.values", levels.values,
      "Process values of all beads, as laser_power_w=1200, wire_speed_mm_s=from_bead; empty for none.");
  schema.number("levels.wire_diameter_mm", levels.wire_diameter_mm, Bounds::above(0.0, 50.0),
                "Diameter of the wire, by which its speed follows from the bead.");
  const Bounds share{0.0, 10.0};
  schema.number("levels.start_share", levels.start_share, share,
                "Share of the process values where a run starts.");
  schema.number("levels.start_mm", levels.start_mm, {0.0, 1000.0},
                "Way over which they become whole; 0 for at once.");
  schema.number("levels.end_share", levels.end_share, share, "Share of the process values where a run ends.");
  schema.number("levels.end_mm", levels.end_mm, {0.0, 1000.0},
                "Way over which they become that share; 0 for not at all.");
  schema.table(
      "levels.channels", levels.channels,
      "What each process value may be and needs, by its name: lower, upper, dead_time_s, start_share, "
      "start_mm, start_hold_s, end_share, end_mm, end_hold_s; of powder density_g_cm3, efficiency.");
  schema.table(
      "levels.rules", levels.rules,
      "Changes of process values where conditions are met, later ones last: a list of when with role, "
      "layers, z_mm, corner_mm or always, and set, scale or law.");
}

void describeWeave(SettingsSchema& schema, WeaveSettings& weave) {
  schema.choice<WeaveKind>("weave.kind", weave.kind,
                           {{"none", WeaveKind::None},
                            {"zigzag", WeaveKind::Zigzag},
                            {"sine", WeaveKind::Sine},
                            {"trapezium", WeaveKind::Trapezium},
                            {"circle", WeaveKind::Circle},
                            {"eight", WeaveKind::Eight}},
                           "How the tip swings across its beads.");
  schema.number("weave.amplitude_mm", weave.amplitude_mm, Bounds::above(0.0, 100.0),
                "Half the width that the tip swings; half the bead at most.");
  schema.number("weave.wavelength_mm", weave.wavelength_mm, Bounds::above(0.0, 1000.0),
                "Length of a wave along the bead; a whole number of half waves is deposited.");
  schema.number("weave.flat_share", weave.flat_share, Bounds::above(0.0, 0.45),
                "Share of a wave that a trapezium keeps to each side.");
  schema.number("weave.left_s", weave.left_s, {0.0, 60.0},
                "Rest on the left of the bead, with the process on.");
  schema.number("weave.right_s", weave.right_s, {0.0, 60.0},
                "Rest on the right of the bead, with the process on.");
  schema.choice<WeaveFeed>("weave.feed", weave.feed,
                           {{"advance", WeaveFeed::Advance}, {"tip", WeaveFeed::Tip}},
                           "Whether feeds are those along the bead, or of the tip.");
  schema.number("weave.tolerance_mm", weave.tolerance_mm, Bounds::above(0.0, 10.0),
                "How far the chords of a sine, circle or eight may be from it.");
  schema.number("weave.swing_deg", weave.swing_deg, {-60.0, 60.0},
                "Angle by which the tool axis turns about the way to the side on which the tip is.");
}

[[noreturn]] void refuseLevels(std::string_view entry, const std::string& expected) {
  throw InvalidConfig("levels.values holds '" + std::string(entry) + "'; " + expected);
}

StatedLevel statedLevel(std::string_view entry) {
  const std::size_t equals = entry.find('=');
  if (equals == std::string_view::npos) refuseLevels(entry, "must be name=value");
  StatedLevel level;
  level.name = std::string(trimmed(entry.substr(0, equals)));
  const bool is_known = std::any_of(
      kAllProcessLevels.begin(), kAllProcessLevels.end(),
      [&](ProcessLevel known) { return known != ProcessLevel::Fan && level.name == nameOf(known); });
  if (!is_known)
    refuseLevels(entry, "known are laser_power_w, wire_speed_mm_s, screw_rpm, powder_g_min, gas_l_min");
  const std::string_view value = trimmed(entry.substr(equals + 1));
  level.is_from_bead = value == kFromBead;
  const bool can_follow =
      std::any_of(kAllProcessLevels.begin(), kAllProcessLevels.end(),
                  [&](ProcessLevel known) { return canFollowBead(known) && level.name == nameOf(known); });
  if (level.is_from_bead && !can_follow)
    refuseLevels(entry, "only wire_speed_mm_s and powder_g_min follow from the bead");
  if (level.is_from_bead) return level;
  const auto result = std::from_chars(value.data(), value.data() + value.size(), level.value);
  const bool is_number = result.ec == std::errc{} && result.ptr == value.data() + value.size();
  if (!is_number || !(level.value >= 0.0 && std::isfinite(level.value)))
    refuseLevels(entry, "the value must be a finite number of 0 or more");
  return level;
}

void requireConsistent(const LevelSettings& levels) {
  const bool is_stated = !statedLevels(levels.values).empty();
  const auto require = [&](bool is_met, const std::string& key_is, const std::string& expected) {
    if (!is_met) throw InvalidConfig(key_is + "; expected " + expected);
  };
  require(is_stated || (levels.start_mm == 0.0 && levels.end_mm == 0.0),
          "levels.start_mm is " + numberText(levels.start_mm) + " mm and levels.end_mm " +
              numberText(levels.end_mm) + " mm with no process values",
          "0, or levels.values");
  require(levels.start_share == 1.0 || levels.start_mm > 0.0,
          "levels.start_share is " + numberText(levels.start_share) + " with levels.start_mm 0 mm",
          "1, or a way");
  require(levels.end_share == 1.0 || levels.end_mm > 0.0,
          "levels.end_share is " + numberText(levels.end_share) + " with levels.end_mm 0 mm", "1, or a way");
  levelChannels(levels);
}

/// Waves have corners of their own.
void requireCornersApart(const BeadRunSettings& settings) {
  if (settings.weave.kind == WeaveKind::None) return;
  for (const LevelRule& rule : levelRules(settings.levels))
    if (rule.when.corner_mm > 0.0)
      throw InvalidConfig("levels.rules has when.corner_mm " + numberText(rule.when.corner_mm) +
                          " mm with a weave; expected weave.kind 'none', or other conditions: waves turn at "
                          "every waypoint");
}

}  // namespace

void describe(SettingsSchema& schema, BeadRunSettings& settings) {
  schema.choice<StartRule>(
      "starts.rule", settings.starts.rule,
      {{"keep", StartRule::Keep}, {"golden", StartRule::Golden}, {"opposite", StartRule::Opposite}},
      "Where closed runs start from layer to layer: as planned, farther by 0.618 of their length, or half "
      "their length on in every other.");
  schema.number("starts.first_share", settings.starts.first_share, {0.0, 1.0},
                "Share of the length, from the planned start, where the first layer starts by such a rule.");
  describeLead(schema, settings.lead);
  schema.number(
      "entry.distance_mm", settings.entry.distance_mm, {0.0, 1000.0},
      "Distance from which the tool comes straight to each run, and to which it leaves; 0 for none.");
  schema.choice<EntryDirection>(
      "entry.direction", settings.entry.direction,
      {{"tool_axis", EntryDirection::ToolAxis},
       {"level", EntryDirection::Level},
       {"tangent", EntryDirection::Tangent}},
      "Whether it comes along the tool axis, straight from above the bed, or on along "
      "the run where there is room.");
  schema.renamedChoice("entry.direction", "jet", "tool_axis");
  schema.number("entry.feed_mm_s", settings.entry.feed_mm_s, Bounds::above(0.0, 10000.0), "Feed there.");
  describeLevels(schema, settings.levels);
  describeWeave(schema, settings.weave);
}

std::vector<StatedLevel> statedLevels(const std::string& text) {
  std::vector<StatedLevel> levels;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view entry = trimmed(rest.substr(0, comma));
    StatedLevel level = statedLevel(entry);
    for (const StatedLevel& other : levels)
      if (other.name == level.name) refuseLevels(entry, "each name once");
    levels.push_back(std::move(level));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return levels;
}

void requireConsistent(const BeadRunSettings& settings) {
  const LeadSettings& lead = settings.lead;
  if (lead.rise_deg > 0.0 && lead.deposit != LeadDeposit::Dry)
    throw InvalidConfig("lead.rise_deg is " + numberText(lead.rise_deg) +
                        " deg with leads that lay a bead; expected 0 deg, or lead.process 'dry'");
  const bool has_loops = lead.in == LeadShape::Loop || lead.out == LeadShape::Loop;
  if (has_loops && lead.deposit != LeadDeposit::Dry)
    throw InvalidConfig(std::string(lead.in == LeadShape::Loop ? "lead.in" : "lead.out") +
                        " is 'loop' with leads that lay a bead; expected 'line' or 'arc', or lead.process "
                        "'dry': where a loop closes three beads would lie on each other");
  const bool has_leads = lead.in != LeadShape::None || lead.out != LeadShape::None;
  if (has_leads && lead.overlap_mm > 0.0 && lead.deposit != LeadDeposit::Dry)
    throw InvalidConfig("lead.overlap_mm is " + numberText(lead.overlap_mm) +
                        " mm with leads that lay a bead; expected 0 mm, or lead.process 'dry': the bead "
                        "that a lead leads to would begin with nothing");
  requireConsistent(settings.levels);
  requireCornersApart(settings);
  const WeaveSettings& weave = settings.weave;
  if (weave.kind == WeaveKind::None && weave.swing_deg != 0.0)
    throw InvalidConfig(
        "weave.swing_deg is " + numberText(weave.swing_deg) +
        " deg with weave.kind 'none'; expected 0 deg, or a weave: the torch swings with its tip");
  for (const auto& [key, rest_s] :
       {std::pair{"weave.left_s", weave.left_s}, std::pair{"weave.right_s", weave.right_s}})
    if (weave.kind == WeaveKind::None && rest_s > 0.0)
      throw InvalidConfig(std::string(key) + " is " + numberText(rest_s) +
                          " s with weave.kind 'none'; expected 0 s, or a weave: the tip rests on its sides");
  if (weave.kind == WeaveKind::None) return;
  if (weave.amplitude_mm > kMostWavesOfSwing * weave.wavelength_mm)
    throw InvalidConfig("weave.amplitude_mm is " + numberText(weave.amplitude_mm) +
                        " mm with weave.wavelength_mm " + numberText(weave.wavelength_mm) +
                        " mm; expected an amplitude of two wavelengths at most");
}

}  // namespace lamina
