// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace lamina {

/// A setting of a job that can be changed while it runs.
enum class LiveSetting : std::uint8_t {
  Feed,          ///< all feeds [%]
  Flow,          ///< all extrusion [%]
  Babystep,      ///< further shift of the nozzle relative to the part [mm, upwards]
  CancelPart,    ///< no longer prints the part of that index, of several on the plate
  PauseAtLayer,  ///< holds in front of that layer's first line
  Rapid,         ///< rapid motions [%], of grbl
  Spindle,       ///< speed of the spindle, power of the laser [%], of grbl
  Power,         ///< the same by the name that driven toolpaths have for it [%]
};

struct LiveChange {
  LiveSetting setting = LiveSetting::Feed;
  double value = 100.0;
};

/// A change by the name of its setting: feed, flow, babystep, cancel_part, pause_at_layer, rapid, spindle,
/// power.
/// @throws InvalidInput if there is no such setting, or the value is out of its bounds: feed, flow and power
/// as
///   `boundsOf` has them, 0.5 mm up or down, an index from 0, a layer from 0, 25, 50 or 100 %, 10 to 200 %
LiveChange liveChange(const std::string& name, double value);

/// The name of a setting: "feed".
std::string nameOf(LiveSetting setting);

/// The refusal of a change by a machine that has no such setting: "grbl has no flow".
/// @param machine  firmware or server, as the subject of the sentence
std::string notOf(const std::string& machine, LiveSetting setting);

/// The refusal of a change while no program runs.
inline constexpr const char* kNoJobToChange = "the job is not under way; expected it in Execute or held";

}  // namespace lamina
