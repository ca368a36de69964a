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
};

struct LiveChange {
  LiveSetting setting = LiveSetting::Feed;
  double value = 100.0;
};

/// A change by its name: feed, flow, babystep, cancel_part, pause_at_layer.
/// @throws InvalidInput if the name is none, or the value is out of bounds: 10 to 300 %, 10 to 300 %, 0.5 mm
/// up
///   or down, an index from 0, a layer from 0
LiveChange liveChange(const std::string& name, double value);

}  // namespace lamina
