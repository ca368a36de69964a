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

/// Figures of one second.
struct HistorySample {
  double utc_s = 0.0;
  double nozzle_degc = kNotMeasured;
  double bed_degc = kNotMeasured;
  double fraction = 0.0;
};

/// Something that has happened, in a sentence.
struct CellEvent {
  std::uint64_t number = 0;  ///< from 1
  double utc_s = 0.0;
  std::string kind;  ///< "state", "alarm", "job", "loop", "start-up"
  std::string text;
};

/// What a cell did lately, derived from what was seen of it: figures of ten minutes, the last 500 events, and
/// how long the job still takes.
class CellHistory {
 public:
  void observe(const CellSnapshot& seen, const CellTime& now);

  const std::deque<HistorySample>& samples() const { return samples_; }
  const std::deque<CellEvent>& events() const { return events_; }
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
