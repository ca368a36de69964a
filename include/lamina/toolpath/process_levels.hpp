// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Quantities that a process may be given besides flow and switches.
enum class ProcessLevel : std::uint8_t { LaserPower, WireSpeed, ScrewSpeed, Powder, Gas, Fan };

inline constexpr std::size_t kProcessLevels = 6;
inline constexpr std::array<ProcessLevel, kProcessLevels> kAllProcessLevels = {
    ProcessLevel::LaserPower, ProcessLevel::WireSpeed, ProcessLevel::ScrewSpeed,
    ProcessLevel::Powder,     ProcessLevel::Gas,       ProcessLevel::Fan};

/// Its name among the process values of a path, with its unit: "laser_power_w", "wire_speed_mm_s",
/// "screw_rpm", "powder_g_min", "gas_l_min"; "fan", a share of 0 to 1, which a toolpath states by events.
const char* nameOf(ProcessLevel level);

/// Whether it goes with the speed of the tip, so that material per length stays: wire and screw.
constexpr bool followsSpeed(ProcessLevel level) {
  return level == ProcessLevel::WireSpeed || level == ProcessLevel::ScrewSpeed;
}

/// A value of each, in the unit of its name; NaN where none is stated.
class ProcessLevels {
 public:
  double& operator[](ProcessLevel level) { return values_[static_cast<std::size_t>(level)]; }
  double operator[](ProcessLevel level) const { return values_[static_cast<std::size_t>(level)]; }
  bool has(ProcessLevel level) const { return !std::isnan((*this)[level]); }

  /// Values that neither states are the same.
  friend bool operator==(const ProcessLevels& a, const ProcessLevels& b) {
    for (const ProcessLevel level : kAllProcessLevels)
      if (a.has(level) != b.has(level) || (a.has(level) && a[level] != b[level])) return false;
    return true;
  }

 private:
  static constexpr double kUnstated = std::numeric_limits<double>::quiet_NaN();
  std::array<double, kProcessLevels> values_ = {kUnstated, kUnstated, kUnstated,
                                                kUnstated, kUnstated, kUnstated};
};

/// What the process values of a path state for the motion to a waypoint.
ProcessLevels levelsTo(const Path& path, std::size_t waypoint);

/// Refuses process values that are no levels, or no finite number of 0 or more.
/// @param by  who takes the toolpath, for the message
/// @throws InvalidInput naming layer, path, name and value
void requireLevels(const Toolpath& toolpath, const std::string& by);

}  // namespace lamina
