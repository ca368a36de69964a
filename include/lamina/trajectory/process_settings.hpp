// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Kind of process, by what is switched.
enum class ProcessKind : std::uint8_t {
  Extruder,  ///< nothing is switched; there is flow alone
  Powder,    ///< powder and gas are on all the time, the laser only while depositing
  Wire,      ///< gas is on all the time, laser and wire only while depositing
};

/// What is switched along a toolpath, and when. A lead is the time by which a device is switched before the
/// start or end of a bead, to compensate for its delay; a negative lead switches the device after the start
/// or end.
struct ProcessSettings {
  ProcessKind kind = ProcessKind::Extruder;
  double laser_on_lead_s = 0.0;
  double laser_off_lead_s = 0.0;
  double wire_on_lead_s = 0.0;
  double wire_off_lead_s = 0.0;
  double settling_s = 0.0;     ///< rest with powder and gas on, before the first motion and after a pause
  double wait_before_s = 0.0;  ///< rest before each bead
  double wait_after_s = 0.0;   ///< rest after each bead
};

/// Adds the keys process.*.
void describe(SettingsSchema& schema, ProcessSettings& settings);

}  // namespace lamina
