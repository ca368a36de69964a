// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/process_levels.hpp"

namespace lamina {

/// Rule by which the starts of closed runs move from layer to layer.
enum class StartRule : std::uint8_t {
  Keep,      ///< where they were planned
  Golden,    ///< moved on by 0.618034 of their length from each layer to the next
  Opposite,  ///< moved on by half their length in every other layer
};

/// How closed runs start in successive layers.
struct StartSettings {
  StartRule rule = StartRule::Keep;
  double first_share = 0.0;  ///< share of the length by which the start in the first layer is moved on
};

/// Shape of a lead: the motion that leads to the beads of a run, or away from them.
enum class LeadShape : std::uint8_t {
  None,
  Line,
  Arc,
  Loop,  ///< a whole circle that touches the run's start or end
};

/// What the process does along a lead.
enum class LeadDeposit : std::uint8_t {
  Dry,   ///< deposits nothing
  Bead,  ///< deposits the run's bead
  Ramp,  ///< deposits a bead that grows to the run's bead, or fades from it
};

/// Leads before and after the beads of a run, and how a closed run is closed.
struct LeadSettings {
  LeadShape in = LeadShape::None;
  LeadShape out = LeadShape::None;
  double length_mm = 10.0;  ///< length of a line
  double angle_deg = 0.0;   ///< angle of a line from the tangent, in the layer
  double rise_deg = 0.0;    ///< angle of a lead out of the layer
  double radius_mm = 5.0;   ///< radius of an arc or a loop
  double sweep_deg = 90.0;  ///< angle of an arc
  double least_mm = 1.0;    ///< leads that are shorter are left out
  LeadDeposit deposit = LeadDeposit::Dry;
  double overlap_mm = 0.0;  ///< length by which a closed run extends over its own start; negative: a gap
};

/// Direction along which a tool approaches a run and leaves it.
enum class EntryDirection : std::uint8_t {
  ToolAxis,  ///< along the tool axis
  Level,     ///< along z of the part's frame
  Tangent,   ///< along the tangent of the run or its lead; along the tool axis where there is no room
};

/// Straight entries to runs from points at a distance, and straight exits to such points.
struct EntrySettings {
  double distance_mm = 0.0;  ///< 0 for none
  EntryDirection direction = EntryDirection::ToolAxis;
  double feed_mm_s = 10.0;
};

/// Process values of all beads, and how they rise and fall at the ends of runs.
struct LevelSettings {
  std::string values;             ///< "laser_power_w=1200, wire_speed_mm_s=from_bead"; empty for none
  double wire_diameter_mm = 1.2;  ///< diameter of the wire, for `from_bead`
  double start_share = 1.0;       ///< share of the value where a run starts
  double start_mm = 0.0;          ///< length over which the value rises from that share to the whole
  double end_share = 1.0;         ///< share of the value where a run ends
  double end_mm = 0.0;            ///< length over which the value falls from the whole to that share
  SettingTable channels;          ///< bounds, dead time, ends and material of each value, by its name
  SettingTable rules;             ///< list of rules that change values; later rules override earlier ones
};

/// Curve on which a tip swings across the centre line of a bead.
enum class WeaveKind : std::uint8_t {
  None,
  Zigzag,
  Sine,
  Trapezium,
  Circle,  ///< circles whose centre advances along the line, one amplitude ahead
  Eight,   ///< figures of eight with a loop on each side; half as long as wide
};

/// The speed that the feed states while a tip weaves.
enum class WeaveFeed : std::uint8_t {
  Advance,  ///< speed along the centre line
  Tip,      ///< speed of the tip itself
};

/// Weaving of the tip across the centre line of beads.
struct WeaveSettings {
  WeaveKind kind = WeaveKind::None;
  double amplitude_mm = 2.0;   ///< greatest offset to each side
  double wavelength_mm = 4.0;  ///< along the centre line
  double flat_share = 0.25;    ///< share of a wave during which a trapezium stays on each side
  double left_s = 0.0;         ///< rest on the left in each wave, with the process on
  double right_s = 0.0;        ///< rest on the right
  WeaveFeed feed = WeaveFeed::Advance;
  double tolerance_mm = 0.05;  ///< greatest distance of chords from the curve
  /// Rotation of the tool axis about the direction of travel where the tip is at the amplitude, towards the
  /// side of the tip.
  double swing_deg = 0.0;
};

/// What is done to runs of beads after they are planned.
struct BeadRunSettings {
  StartSettings starts;
  LeadSettings lead;
  EntrySettings entry;
  LevelSettings levels;
  WeaveSettings weave;
};

/// Adds the keys starts.*, lead.*, entry.*, levels.*, weave.*.
void describe(SettingsSchema& schema, BeadRunSettings& settings);

/// Whether a process value can be computed from bead and feed: wire and powder.
constexpr bool canFollowBead(ProcessLevel level) {
  return level == ProcessLevel::WireSpeed || level == ProcessLevel::Powder;
}

/// A process value of all beads.
struct StatedLevel {
  std::string name;
  double value = 0.0;         ///< in the unit of the name
  bool is_from_bead = false;  ///< computed from bead and feed instead
};

/// The values in a list "name=value, ...", in its order.
/// @throws InvalidConfig if an entry is not of that form; if a name is none of `ProcessLevel`, or stands
///   twice; if a value is negative or no number; if `from_bead` is given for a name that cannot be computed
///   (`canFollowBead`)
std::vector<StatedLevel> statedLevels(const std::string& text);

/// @throws InvalidConfig naming key, value and unit, for a contradiction: a lead that rises and deposits, a
///   loop that deposits, a lead that deposits together with an overlap, a weave that is wider than four of
///   its waves, a swing of the torch or rests without a weave, shares without a length over which they change
void requireConsistent(const BeadRunSettings& settings);

}  // namespace lamina
