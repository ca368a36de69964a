// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Where closed runs start, from layer to layer.
enum class StartRule : std::uint8_t {
  Keep,      ///< where they were planned
  Golden,    ///< by 0.618034 of their length farther in each layer
  Opposite,  ///< half their length on in every other layer
};

/// How closed runs start in successive layers.
struct StartSettings {
  StartRule rule = StartRule::Keep;
  double first_share = 0.0;  ///< of the length, where the first layer starts
};

/// The way of a lead.
enum class LeadShape : std::uint8_t {
  None,
  Line,
  Arc,
  Loop,  ///< a whole circle, from where the run begins or ends and back
};

/// What the process does along a lead.
enum class LeadDeposit : std::uint8_t {
  Dry,   ///< lays nothing
  Bead,  ///< lays the run's bead
  Ramp,  ///< lays a bead that grows to that of the run, or fades from it
};

/// Ways before and after the beads of a run, and how a closed one is closed.
struct LeadSettings {
  LeadShape in = LeadShape::None;
  LeadShape out = LeadShape::None;
  double length_mm = 10.0;  ///< of a line
  double angle_deg = 0.0;   ///< of a line, from the tangent, in the layer
  double rise_deg = 0.0;    ///< out of the layer
  double radius_mm = 5.0;   ///< of an arc or a loop
  double sweep_deg = 90.0;  ///< of an arc
  double least_mm = 1.0;    ///< leads that are shorter are left out
  LeadDeposit deposit = LeadDeposit::Dry;
  double overlap_mm = 0.0;  ///< by which a closed run goes on over its start; 0 for none
};

/// Which way a tool comes to a run.
enum class EntryDirection : std::uint8_t {
  ToolAxis,  ///< along the tool axis
  Level,     ///< along z of the part's frame
  Tangent,   ///< on along the run or its lead; along the tool axis where there is no room
};

/// Points before and after each run, from and to which the tool goes straight.
struct EntrySettings {
  double distance_mm = 0.0;  ///< 0 for none
  EntryDirection direction = EntryDirection::ToolAxis;
  double feed_mm_s = 10.0;
};

/// Process values of all beads, and how they rise and fall at the ends of runs.
struct LevelSettings {
  std::string values;             ///< "laser_power_w=1200, wire_speed_mm_s=from_bead"; empty for none
  double wire_diameter_mm = 1.2;  ///< of `from_bead`
  double start_share = 1.0;       ///< of the value, where a run starts
  double start_mm = 0.0;          ///< over which it becomes the whole value
  double end_share = 1.0;         ///< of the value, where a run ends
  double end_mm = 0.0;            ///< over which it becomes that share
};

/// How a tip swings across its way.
enum class WeaveKind : std::uint8_t {
  None,
  Zigzag,
  Sine,
  Trapezium,
  Circle,  ///< round and round, ahead of the line
  Eight,   ///< round a loop on each side, half as far ahead and back as aside
};

/// What a feed is of, where a tip weaves.
enum class WeaveFeed : std::uint8_t {
  Advance,  ///< along the centre line
  Tip,
};

/// Weaving of the tip across the centre line of beads.
struct WeaveSettings {
  WeaveKind kind = WeaveKind::None;
  double amplitude_mm = 2.0;   ///< half the width that is swung
  double wavelength_mm = 4.0;  ///< along the centre line
  double flat_share = 0.25;    ///< of a wave, on each side of a trapezium
  double left_s = 0.0;         ///< rest on the left, with the process on
  double right_s = 0.0;
  WeaveFeed feed = WeaveFeed::Advance;
  double tolerance_mm = 0.05;  ///< from chord to curve
  double swing_deg =
      0.0;  ///< of the tool axis about the way, to the side on which the tip is; at the amplitude
};

/// What becomes of runs of beads once they are planned.
struct BeadRunSettings {
  StartSettings starts;
  LeadSettings lead;
  EntrySettings entry;
  LevelSettings levels;
  WeaveSettings weave;
};

/// Adds the keys starts.*, lead.*, entry.*, levels.*, weave.*.
void describe(SettingsSchema& schema, BeadRunSettings& settings);

/// A process value of all beads.
struct StatedLevel {
  std::string name;
  double value = 0.0;         ///< in the unit of the name
  bool is_from_bead = false;  ///< follows from bead and feed instead
};

/// In the order in which they stand.
/// @throws InvalidConfig if it is no list of name=value, a name is none of `ProcessLevel`, stands twice, or a
///   value is negative or no number; `from_bead` is of wire_speed_mm_s alone
std::vector<StatedLevel> statedLevels(const std::string& text);

/// @throws InvalidConfig naming key, value and unit: a lead that rises while it lays, a loop that lays, one
///   that lays beside an overlap, a weave that is wider than four of its waves, a swing of the torch without
///   a weave, shares or rests without the weave or ramp that they are of
void requireConsistent(const BeadRunSettings& settings);

}  // namespace lamina
