// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a layer reaches its least time: by lower feeds and, where these do not suffice, a dwell; by lower
/// feeds only; by a dwell only.
enum class CoolingBy : std::uint8_t { SlowThenDwell, Slow, Dwell };

/// Where the nozzle waits.
enum class ParkPlace : std::uint8_t {
  Outside,  ///< beside the part, on the side of the least x
  Corner,   ///< over the corner of least x and y of the part's bounding box
  Stay      ///< above its position at that time
};

/// The interval to which the least time applies.
enum class CoolingInterval : std::uint8_t {
  Layer,  ///< from the start of a layer to its end
  Place   ///< from the end of an island to the start of the island above it
};

/// The least time of layers.
struct CoolingSettings {
  double least_layer_time_s = 0.0;  ///< 0 for none
  CoolingBy by = CoolingBy::SlowThenDwell;
  double least_feed_mm_s = 10.0;  ///< lower bound of deposition feeds
  double lift_mm = 2.0;           ///< lift of the nozzle while it waits
  ParkPlace park = ParkPlace::Outside;
  CoolingInterval interval = CoolingInterval::Layer;
};

/// Power of the fan by the time of a layer.
struct FanSettings {
  enum class WhenSlow : std::uint8_t { Least, None };

  bool is_used = false;
  int off_layers = 1;                 ///< number of first layers without fan
  double least = 0.35;                ///< least share of its power
  double greatest = 1.0;              ///< greatest share
  double full_below_s = 5.0;          ///< layer time up to which the greatest share is used
  double least_at_s = 60.0;           ///< layer time with the least share; linear in between
  WhenSlow beyond = WhenSlow::Least;  ///< share for layers longer than `least_at_s`
  double bridge = 1.0;                ///< share for bridges
  double overhang = 1.0;              ///< share for unsupported walls and skins
  std::string by_role;                ///< shares for other roles: "support_interface=1,top_skin=0.8"
  double spin_up_s = 0.0;             ///< lead time of commands that raise the fan
};

/// Adds the keys cooling.*.
void describe(SettingsSchema& schema, CoolingSettings& settings);
/// Adds the keys fan.*; `fan.off_above_s`, the former name of `fan.least_at_s`, is accepted for one release.
void describe(SettingsSchema& schema, FanSettings& settings);

/// @throws InvalidConfig if the least share is above the greatest, `full_below_s` is above `least_at_s`, or
///   `by_role` is not a list of roles and shares
void requireConsistent(const FanSettings& settings);
/// @throws InvalidConfig if `interval` is Place and `by` is not Dwell
void requireConsistent(const CoolingSettings& settings);

}  // namespace lamina
