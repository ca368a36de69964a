// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/startup/startup_settings.hpp"
#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// Range of the heights of a bed's surface.
struct BedHeights {
  double low_mm = 0.0;     ///< least height
  double high_mm = 0.0;    ///< greatest height
  std::size_t points = 0;  ///< number of heights
};

/// A temperature, and the time at which it was reported.
struct TimedTemperature {
  double time_s = 0.0;
  double value_c = 0.0;
};

/// The latest values that a machine has reported for its start-up. A value that was never reported is empty.
///
/// The sources are temperatures in the format of Marlin, values after the labels of the settings, and the
/// rows of numbers after a line with "Leveling Grid" (G29). Times are machine times [s] and never go back.
class MachineReports {
 public:
  explicit MachineReports(const StartupSettings& settings);

  /// Reads one line that the machine has sent.
  void read(const FirmwareReply& reply, double now_s);

  /// Resets `fastestBed`.
  void watchBed();
  void forgetDryer() { dryer_.reset(); }
  void forgetZones() { zone_kpa_.clear(); }
  void forgetHomed() { homed_.reset(); }
  void forgetHeights() { heights_.reset(); }

  std::optional<double> bed() const { return bed_c_; }
  /// Greatest heating rate of the bed since `watchBed`, measured over two minutes at a time [K/min].
  double fastestBed() const { return fastest_bed_c_min_; }
  std::optional<TimedTemperature> dryer() const { return dryer_; }
  /// Absolute pressures of the vacuum zones, by number [kPa].
  const std::map<int, double>& zones() const { return zone_kpa_; }
  /// Letters of the homed axes, such as "XY".
  const std::optional<std::string>& homed() const { return homed_; }
  const std::optional<BedHeights>& heights() const { return heights_; }

 private:
  void readBed(double bed_c, double now_s);
  void readLabels(std::string_view text, double now_s);
  void readHeights(std::string_view text);

  std::string dryer_label_;
  std::string homed_label_;
  std::map<int, std::string> zone_labels_;

  std::optional<double> bed_c_;
  std::optional<TimedTemperature> window_start_;
  double fastest_bed_c_min_ = 0.0;
  std::optional<TimedTemperature> dryer_;
  std::map<int, double> zone_kpa_;
  std::optional<std::string> homed_;
  std::optional<BedHeights> heights_;
  bool is_in_grid_ = false;
};

}  // namespace lamina
