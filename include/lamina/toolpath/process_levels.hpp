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

/// A quantity of the process that a toolpath can set, besides flow and on-off signals.
enum class ProcessLevel : std::uint8_t { LaserPower, WireSpeed, ScrewSpeed, Powder, Gas, Fan };

inline constexpr std::size_t kProcessLevels = 6;
inline constexpr std::array<ProcessLevel, kProcessLevels> kAllProcessLevels = {
    ProcessLevel::LaserPower, ProcessLevel::WireSpeed, ProcessLevel::ScrewSpeed,
    ProcessLevel::Powder,     ProcessLevel::Gas,       ProcessLevel::Fan};

/// The name of a level among the process values of a path, with its unit: "laser_power_w",
/// "wire_speed_mm_s", "screw_rpm", "powder_g_min", "gas_l_min". Also "fan", a share from 0 to 1, which is set
/// by events instead.
const char* nameOf(ProcessLevel level);

/// Whether a level is scaled with the speed of the tip, so that the material per length stays the same: wire
/// and screw.
constexpr bool followsSpeed(ProcessLevel level) {
  return level == ProcessLevel::WireSpeed || level == ProcessLevel::ScrewSpeed;
}

/// The values of all levels, each in the unit of its name; NaN for one that is not stated.
class ProcessLevels {
 public:
  double& operator[](ProcessLevel level) { return values_[static_cast<std::size_t>(level)]; }
  double operator[](ProcessLevel level) const { return values_[static_cast<std::size_t>(level)]; }
  bool has(ProcessLevel level) const { return !std::isnan((*this)[level]); }

  /// Values that are stated in neither count as equal.
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

/// The levels that the process values of a path state for the motion to a waypoint.
ProcessLevels levelsTo(const Path& path, std::size_t waypoint);

/// Refuses a toolpath with process values that are no levels, or that are negative or not finite.
/// @param by  who processes the toolpath, for the message
/// @throws InvalidInput naming layer, path, name and value
void requireLevels(const Toolpath& toolpath, const std::string& by);

}  // namespace lamina
