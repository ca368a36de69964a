// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"
#include "lamina/streaming/job/stream_job.hpp"

namespace lamina {

/// Counts, from its reports, how often a machine ran out of motions.
class GrblStarvation {
 public:
  /// Evaluates a report while lines should be arriving.
  /// @param blocks  number of blocks of the motion queue; 0 if not reported
  /// @param line    the line that comes next
  void see(const GrblReport& report, int blocks, std::uint64_t line, double now) {
    const bool is_empty =
        report.state == GrblState::Idle || (blocks > 0 && report.free_blocks.value_or(0) >= blocks);
    if (!is_empty) return end();
    if (!since_) {
      since_ = now;
      ++starvation_.count;
    }
    if (now - *since_ < starvation_.longest_s) return;
    starvation_.longest_s = now - *since_;
    starvation_.line = line;
  }
  /// States that no lines are due now.
  void end() { since_.reset(); }

  const Starvation& starvation() const { return starvation_; }

 private:
  Starvation starvation_;
  std::optional<double> since_;  ///< time of the first report of an empty queue
};

}  // namespace lamina
