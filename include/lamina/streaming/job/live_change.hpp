// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace lamina {

/// What a person may change while a job runs.
enum class LiveSetting : std::uint8_t {
  Feed,          ///< all feeds [%]
  Flow,          ///< all extrusion [%]
  Babystep,      ///< moves the nozzle against the part by so much more [mm, upwards]
  CancelPart,    ///< no longer prints the part of that index, of several on the plate
  PauseAtLayer,  ///< holds in front of that layer's first line
  Rapid,         ///< rapid motions [%], of grbl
  Spindle,       ///< speed of the spindle, power of the laser [%], of grbl
};

struct LiveChange {
  LiveSetting setting = LiveSetting::Feed;
  double value = 100.0;
};

/// A change by its name: feed, flow, babystep, cancel_part, pause_at_layer, rapid, spindle.
/// @throws InvalidInput if the name is none, or the value is out of bounds: 10 to 300 %, 10 to 300 %, 0.5 mm
///   up or down, an index from 0, a layer from 0, 25, 50 or 100 %, 10 to 200 %
LiveChange liveChange(const std::string& name, double value);

/// A setting by its name: "feed".
std::string nameOf(LiveSetting setting);

/// Why a machine does not take a change, in words: "grbl has no flow".
/// @param machine  firmware or server, as the subject of the sentence
std::string notOf(const std::string& machine, LiveSetting setting);

/// Why no change is taken while no program is run.
inline constexpr const char* kNoJobToChange = "the job is not under way; expected it in Execute or held";

}  // namespace lamina
