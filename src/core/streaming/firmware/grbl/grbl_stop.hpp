// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

namespace lamina {

/// The safe stop of grbl: a feed hold, so that the axes slow down without losing steps; when they are at rest
/// a reset, which forgets all lines and ends spindle, laser and coolant; then a greeting, and a report that
/// says so.
class GrblStop {
 public:
  /// Whether anything may still move.
  enum class Motion { Possible, EndedByAlarm };

  /// @param timeout_s  of which one half is for slowing down, before the machine is reset whatever it does
  GrblStop(Motion motion, double timeout_s, double now);

  void hear(const GrblReply& reply, double now);
  void elapse(double now);
  double nextDeadline() const { return next_step_s_; }
  std::string takeOutput();

  bool isConfirmed() const { return is_confirmed_; }
  /// What has to be known of a stop that did not go as it should; for the end of a message.
  std::string remark() const;

 private:
  void onReport(const GrblReport& report, double now);
  void onHalting(const GrblReport& report, double now);
  void reset(double now);

  double reset_by_s_;
  double next_step_s_;
  double reset_at_s_ = 0.0;
  double idle_at_s_ = -1.0;  ///< of the first of two reports; -1 if there is none
  bool is_resetting_ = false;
  bool was_moving_ = false;  ///< when it was reset
  bool has_greeted_ = false;
  bool is_confirmed_ = false;
  std::string output_;
};

}  // namespace lamina
