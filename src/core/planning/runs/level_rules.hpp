// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/planning/runs/bead_run_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How a process value begins where a run starts, or ends where it ends.
struct LevelEnd {
  double share = 1.0;    ///< of the value, at that end
  double over_mm = 0.0;  ///< length of the ramp from the share to the whole value
  double hold_s = 0.0;   ///< time for which the share is held at that end
};

/// A process value of all beads, with what its device can do.
struct LevelChannel {
  StatedLevel stated;
  double lower = 0.0;  ///< in the unit of the name
  double upper = std::numeric_limits<double>::infinity();
  double dead_time_s = 0.0;
  double density_g_cm3 = 0.0;  ///< of powder
  double efficiency = 1.0;     ///< share of the powder that is melted
  LevelEnd start;
  LevelEnd end;
};

/// The beads to which a rule applies: those that meet all conditions.
struct LevelCondition {
  std::optional<PathRole> role;
  std::vector<double> layers;  ///< the first and the last, by index from 0; empty for all
  std::vector<double> z_mm;    ///< lowest and highest top of layers; empty for all
  double corner_mm = 0.0;      ///< greatest distance from a corner; 0 for no limit
};

enum class LevelLaw : std::uint8_t {
  Constant,
  FromBead,
  Scale,      ///< the value before, times a factor
  PerLength,  ///< times the feed
  PerVolume,  ///< times feed and section of the bead
  OverLayer,  ///< table over the index of the layer
  OverZ,      ///< table over the height of the layer
  Approach,   ///< from the first layer to a last value, exponentially
};

/// What a rule does to a channel.
struct ChannelChange {
  std::string channel;
  LevelLaw law = LevelLaw::Constant;
  double value = 0.0;                             ///< constant, factor, or value at the first layer, by `law`
  double last = 0.0;                              ///< value that `Approach` leads to
  double layers = 1.0;                            ///< in which `Approach` covers 63 % of the difference
  std::vector<std::pair<double, double>> points;  ///< of a table, in order
};

struct LevelRule {
  LevelCondition when;
  std::vector<ChannelChange> changes;  ///< in the order in which they are made
};

/// A motion that deposits, as rules see it.
struct LevelPlace {
  PathRole role = PathRole::Infill;
  std::size_t layer = 0;
  double z_mm = 0.0;
  double corner_mm = std::numeric_limits<double>::infinity();  ///< along the run, to the nearest corner
  double feed_mm_s = 0.0;
  Bead bead;
  double wire_mm = 0.0;  ///< diameter
};

/// A value, and the setting that it comes from.
struct RuledLevel {
  double value = 0.0;
  std::string by;  ///< "levels.values", or "levels.rules 2"
};

/// The channels of the settings, in the order of `levels.values`.
/// @throws InvalidConfig naming key and value as `statedLevels`; if `levels.channels` names another channel,
///   an unknown key, or bounds that contradict each other; if powder is computed from the bead and no density
///   is given
std::vector<LevelChannel> levelChannels(const LevelSettings& settings);

/// The rules of the settings, in their order.
/// @throws InvalidConfig naming rule, key and value if a rule is incomplete, has no condition, or names a
///   channel that is not in `levels.values`
std::vector<LevelRule> levelRules(const LevelSettings& settings);

/// The value of a channel on a motion: the stated one, changed by the rules. Later rules override earlier
/// ones.
RuledLevel ruledLevel(const LevelChannel& channel, const std::vector<LevelRule>& rules,
                      const LevelPlace& place);

/// The unit of a channel: "W".
std::string unitOfLevel(const std::string& channel);

}  // namespace lamina
