// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/streaming/emulator/emulated_settings.hpp"

namespace lamina {

/// Zones of a vacuum bed, numbered from 1. The pressure of each approaches that of the pump, of a leak, or of
/// the atmosphere exponentially.
class EmulatedVacuum {
 public:
  static constexpr double kAirKpa = 101.325;

  explicit EmulatedVacuum(const EmulatedSettings& settings);

  bool has(int zone) const { return zone >= 1 && zone <= static_cast<int>(zones_.size()); }
  void open(int zone) { zones_.at(index(zone)).is_open = true; }
  void close(int zone) { zones_.at(index(zone)).is_open = false; }
  void switchOff();
  void elapse(double seconds);
  /// Absolute pressure of a zone [kPa].
  double pressure(int zone) const { return zones_.at(index(zone)).kpa; }
  bool isOpen(int zone) const { return zones_.at(index(zone)).is_open; }

 private:
  struct Zone {
    double kpa = kAirKpa;
    double lowest_kpa = 0.0;
    bool is_open = false;
  };

  static std::size_t index(int zone) { return static_cast<std::size_t>(zone - 1); }

  std::vector<Zone> zones_;
  double time_s_;
};

}  // namespace lamina
