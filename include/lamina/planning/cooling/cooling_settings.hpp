// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings.hpp"

namespace lamina {

/// What makes a layer take as long as it must.
enum class CoolingBy : std::uint8_t { SlowThenDwell, Slow, Dwell };

/// Where the nozzle waits.
enum class ParkPlace : std::uint8_t {
  Outside,  ///< beside the part, on the side of the least x
  Corner,   ///< over the corner of the part's box of least x and y
  Stay      ///< over where it was
};

/// What is left alone for the least time.
enum class CoolingInterval : std::uint8_t {
  Layer,  ///< from the begin of a layer to its end
  Place   ///< each island, from when the nozzle leaves it to when it comes back a layer higher
};

/// How long layers take at least.
struct CoolingSettings {
  double least_layer_time_s = 0.0;  ///< 0 for none
  CoolingBy by = CoolingBy::SlowThenDwell;
  double least_feed_mm_s = 10.0;  ///< lower bound of deposition feeds
  double lift_mm = 2.0;           ///< while it waits
  ParkPlace park = ParkPlace::Outside;
  CoolingInterval interval = CoolingInterval::Layer;
};

/// How the fan blows, by the time of the layer.
struct FanSettings {
  enum class WhenSlow : std::uint8_t { Least, None };

  bool is_used = false;
  int off_layers = 1;   ///< so many first layers without
  double least = 0.35;  ///< shares of its power
  double greatest = 1.0;
  double full_below_s = 5.0;          ///< of layer time: the greatest share
  double least_at_s = 60.0;           ///< of layer time: the least share; between the two, linear
  WhenSlow beyond = WhenSlow::Least;  ///< of layers that take longer
  double bridge = 1.0;                ///< while a bridge is laid
  double overhang = 1.0;              ///< while walls and skins are laid that nothing carries
  std::string by_role;                ///< shares of other roles, as `support_interface=1,top_skin=0.8`
  double spin_up_s = 0.0;             ///< lead time of commands that raise the fan
};

/// Adds the keys cooling.*.
void describe(SettingsSchema& schema, CoolingSettings& settings);
/// Adds the keys fan.*; `fan.off_above_s`, the former name of `fan.least_at_s`, is taken for one release.
void describe(SettingsSchema& schema, FanSettings& settings);

/// @throws InvalidConfig if the least share is above the greatest, `full_below_s` is above `least_at_s`, or
///   `by_role` is not a list of roles and shares
void requireConsistent(const FanSettings& settings);
/// @throws InvalidConfig if `interval` is Place and `by` is not Dwell
void requireConsistent(const CoolingSettings& settings);

}  // namespace lamina
