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
  Babystep,      ///< further shift of the nozzle relative to the part [mm], positive upwards
  CancelPart,    ///< part that is no longer printed, by its index among those on the plate
  PauseAtLayer,  ///< number of the layer before whose first line the job holds
  Rapid,         ///< speed of rapid motions [%]; only for grbl
  Spindle,       ///< speed of the spindle, or power of the laser [%]; only for grbl
  Power,         ///< power of the laser [%], under the name that it has in driven toolpaths
};

/// A change of a setting of the running job.
struct LiveChange {
  LiveSetting setting = LiveSetting::Feed;
  double value = 100.0;
};

/// Makes a change from the name of a setting and a value. Bounds are: feed, flow, power: as `boundsOf`, in
/// percent; babystep: -0.5 to 0.5 mm; cancel_part: 0 to 9999; pause_at_layer: 0 to 1000000; rapid: 25 to
/// 100 %; spindle: 10 to 200 %. All but feed, flow and babystep must be whole numbers.
/// @throws InvalidInput if there is no such setting, or the value is out of its bounds
LiveChange liveChange(const std::string& name, double value);

/// The name of a setting: "feed".
std::string nameOf(LiveSetting setting);

/// The message by which a machine without such a setting refuses a change: "grbl has no flow".
/// @param machine  name of the firmware or server, the subject of the sentence
std::string notOf(const std::string& machine, LiveSetting setting);

/// The message by which a change is refused while no program runs.
inline constexpr const char* kNoJobToChange = "the job is not under way; expected it in Execute or held";

}  // namespace lamina
