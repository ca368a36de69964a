// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/run/standing_alarms.hpp"
#include "lamina/control/supervision.hpp"

namespace lamina {

/// The alarms of a print whose cause lasts (`isCondition`), from when they are raised until their cause is
/// gone. A watch that finds nothing does not end all of them: between two scans nothing is watched.
class StandingConditions {
 public:
  /// Adds an alarm that was raised, in the place of an earlier one of the same number; an alarm whose cause
  /// does not last is ignored.
  void raise(const RaisedAlarm& alarm);
  /// Takes over the alarms that stood when the loop was last known. Those of a stuck sensor and of a time
  /// offset stand until a layer is measured, since new watches know nothing of them yet.
  void resume(const std::vector<RaisedAlarm>& stood);
  /// A layer was measured: from now on the watches know of all sensors.
  void endResumption() { is_resumed_ = false; }
  /// Ends alarms that no longer hold by the watches: all if the loop does not run, that of a stuck sensor
  /// that gives profiles again, that of a time offset for which the loop no longer coasts.
  void settle(const LoopStatus& status, const StandingAlarms& watched);
  /// A cloud was read that has a pose, or a layer was judged: ends the silence, and the loss of poses, that
  /// is not watched now. Clouds alone do not end the silence of layers that were not measured.
  void settleSight(const LoopStatus& status, const StandingAlarms& watched);
  void end(LoopAlarm alarm);
  /// Nothing is expected any more.
  void endAll() { conditions_.clear(); }

  /// The alarms that stand, in the order in which they were raised.
  const std::vector<RaisedAlarm>& all() const { return conditions_; }

 private:
  std::vector<RaisedAlarm> conditions_;
  bool is_resumed_ = false;
};

}  // namespace lamina
