// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/production_cell.hpp"
#include "lamina/cell/time_left.hpp"
#include "lamina/web/cell_desk.hpp"

namespace lamina {

/// Figures of the cell at one second.
struct HistorySample {
  double utc_s = 0.0;
  double nozzle_degc = kNotMeasured;
  double bed_degc = kNotMeasured;
  double fraction = 0.0;
};

/// The machine as it is now: temperatures that it reported more than 5 s ago, for example before its last job
/// ended, are `kNotMeasured`.
ShownMachine presentMachine(const CellSnapshot& seen, const CellTime& now);

/// An event in the cell, described in a sentence.
struct CellEvent {
  std::uint64_t number = 0;  ///< from 1
  double utc_s = 0.0;
  std::string kind;  ///< "state", "alarm", "job", "loop", "start-up"
  std::string text;
};

/// The recent history of a cell, derived from snapshots of it: figures of the last ten minutes, the last 500
/// events, and an estimate of the time that the job still takes.
class CellHistory {
 public:
  /// Adds a snapshot; ignored before the unit's first report.
  void observe(const CellSnapshot& seen, const CellTime& now);

  const std::deque<HistorySample>& samples() const { return samples_; }
  const std::deque<CellEvent>& events() const { return events_; }
  /// Estimate of the time that the job still takes; nothing without a job.
  std::optional<LeftEstimate> left() const;

 private:
  void compare(const CellSnapshot& seen, double utc_s);
  void compareAlarms(const CellSnapshot& seen, double utc_s);
  void compareQueue(const CellSnapshot& seen, double utc_s);
  void add(double utc_s, const char* kind, const std::string& text);
  void estimate(const CellSnapshot& seen, double steady_s);

  std::deque<HistorySample> samples_;
  std::deque<CellEvent> events_;
  std::uint64_t last_event_ = 0;
  std::optional<CellSnapshot> before_;
  std::optional<double> sampled_s_;
  TimeLeft left_;
};

}  // namespace lamina
