// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "lamina/process_io/channel_drive.hpp"

namespace lamina {

/// A change of an alarm (docs/cell/cell.md): the alarm is raised, or its cause has gone.
struct ProcessAlarm {
  std::uint16_t id = 0;
  std::string source;
  double value = 0.0;
  std::string message;  ///< empty if the cause has gone
  bool is_gone = false;
};

/// A row of the tables that raises alarms. Rows of different tables may share a name.
struct AlarmSource {
  enum class Table : std::uint8_t { Devices, Channels, Inputs };
  std::string name;
  Table table = Table::Devices;
};

/// Holds the alarms that are raised, and reports each change once.
class RaisedAlarms {
 public:
  /// Raises an alarm of a source, or clears it.
  /// @param wrong  what is wrong now, in words; nothing if all is well
  void set(std::uint16_t id, const AlarmSource& source, const std::optional<std::string>& wrong,
           double value);
  /// Alarms raised and cleared since the last call. A cleared alarm is reported once no source raises it any
  /// more.
  std::vector<ProcessAlarm> takeChanges() { return std::exchange(changes_, {}); }
  std::vector<ProcessAlarm> all() const;
  /// Message of the first alarm that is raised; empty if none is.
  std::string first() const { return raised_.empty() ? std::string() : raised_.begin()->second.message; }

 private:
  std::map<std::tuple<std::uint16_t, std::string, AlarmSource::Table>, ProcessAlarm> raised_;
  std::vector<ProcessAlarm> changes_;
};

/// Checks the inputs of devices against what was sent (alarms 5101, 5102, 5106, 5107).
class InputWatch {
 public:
  explicit InputWatch(std::vector<InputChannel> inputs)
      : inputs_(std::move(inputs)), wrong_since_(inputs_.size()) {}

  const std::vector<InputChannel>& inputs() const { return inputs_; }

  /// @param measured  of each input [unit of its channel]; NaN if it is not read, and then not checked
  void look(const std::vector<double>& measured, const std::vector<ChannelDrive>& drives, double now_s,
            RaisedAlarms& raised);

 private:
  std::vector<InputChannel> inputs_;
  std::vector<std::optional<double>> wrong_since_;
};

/// Measures for how long no joint has moved.
class StandstillWatch {
 public:
  /// Positions of joints by name [m, rad]: all joints of a machine, or the joints that one of several sources
  /// reports. A joint that is reported for the first time, or whose position is no number, does not count as
  /// moved.
  void hear(const std::map<std::string, double>& positions, double now_s);
  /// Time without motion [s], counted from `since_s` at the earliest.
  double stillFor(double since_s, double now_s) const;

 private:
  std::map<std::string, double> positions_;  ///< where each joint moved to last
  std::optional<double> moved_s_;
};

}  // namespace lamina
