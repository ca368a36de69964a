// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/production_cell.hpp"

namespace lamina {

/// What begins the next job once a part is complete.
enum class QueueAdvance : std::uint8_t {
  Ask,        ///< Reset and Start of a person or a PLC
  Automatic,  ///< the queue itself, once the part was taken away
};

/// The conditions of a start that the caller must determine.
struct StartOutlook {
  CellSurroundings found;
  std::vector<UnmetGuard> unmet;  ///< reasons against it that the caller has found
};

/// Leads a unit from a complete part to the next job of its queue, by the commands Reset and Start of the
/// source "queue".
///
/// Reset is given in Complete, once the part was taken away, a job is allowed to start, and no alarm of
/// category Suspend or graver is active; Start follows in Idle once nothing is against it. The queue gives no
/// other command and waits for a person after all else: when the process begins, after Stop, Abort and a
/// change of the mode, after a Reset that was not its own, and when one of its commands is refused.
class QueueFollower {
 public:
  explicit QueueFollower(QueueAdvance rule) : rule_(rule) {}

  /// The command that the queue has to give in this state of the unit, even if it cannot be given yet. To be
  /// called after each command that somebody else gives.
  std::optional<UnitCommand> observe(const UnitStatus& unit);

  /// Gives the queue's command if it is its turn and nothing is against it; once a second at most.
  /// @param look  called only when a start is due
  void follow(ProductionCell& cell, const std::function<StartOutlook()>& look, CellTime now);

  /// The reasons why the next job does not start by itself yet, or why the queue's last command was refused;
  /// empty if it is not the queue's turn, or nothing is against the start.
  const std::string& waitsFor() const { return waits_for_; }

 private:
  QueueAdvance rule_;
  bool is_reset_by_queue_ = false;  ///< the unit was reset last by the queue
  /// Number of the state change after which a command of the queue was refused.
  std::optional<std::uint32_t> refused_after_;
  std::optional<double> looked_s_;
  std::string waits_for_;
};

}  // namespace lamina
