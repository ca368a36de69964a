// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"
#include "streaming/firmware/grbl/grbl_standstill.hpp"

namespace lamina {

/// The safe stop of grbl. A feed hold slows the axes down without loss of steps. Once they are at rest, a
/// reset discards all lines and switches off spindle, laser and coolant. The greeting and a report after the
/// reset confirm the stop.
class GrblStop {
 public:
  /// Whether anything may still move.
  enum class Motion { Possible, EndedByAlarm };

  /// @param timeout_s  longest time for the stop; after half of it the machine is reset, even if it still
  ///   moves
  GrblStop(Motion motion, double timeout_s, double now);

  void hear(const GrblReply& reply, double now);
  void elapse(double now);
  double nextDeadline() const { return next_step_s_; }
  std::string takeOutput();

  bool isConfirmed() const { return is_confirmed_; }
  /// Remark on a stop that did not go as planned, for the end of a message.
  std::string remark() const;

 private:
  void onReport(const GrblReport& report, double now);
  void onHalting(const GrblReport& report, double now);
  void reset(double now);

  double reset_by_s_;
  double next_step_s_;
  double reset_at_s_ = 0.0;
  GrblStandstill standstill_;
  bool is_resetting_ = false;
  bool was_moving_ = false;  ///< whether the machine was moving when it was reset
  bool has_greeted_ = false;
  bool is_confirmed_ = false;
  std::string output_;
};

}  // namespace lamina
