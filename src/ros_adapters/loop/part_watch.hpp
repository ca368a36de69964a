// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "messages.hpp"

namespace lamina {

/// Tells by the states of a machine whether it begins another part of a toolpath that is not announced again,
/// as executors print one as often as they are asked to, or goes on with a job that was cut off.
class PartWatch {
 public:
  /// States that a part begins: how the one before ended says nothing of it.
  void begin() { *this = {}; }

  /// Takes a state of the machine. A job that begins after one that was complete is another part. After one
  /// that was cut off it is if it is at a layer below: below the one that the machine stated at the end, or
  /// by two at least, since a machine states its layers late.
  /// @param layer  at which the nozzle was seen last
  /// @return whether another part begins with it
  bool see(const lamina_msgs::MachineState& machine, std::size_t layer);

  /// Whether the machine was seen in a state that is no end since the part began.
  bool hasRun() const { return has_run_; }

 private:
  struct End {
    std::uint8_t state = 0;
    std::int32_t layer = 0;
  };
  bool has_run_ = false;
  std::optional<End> end_;  ///< of the job that ended last; none once one goes on
};

/// Whether a job is run by that state.
bool isUnderWay(const lamina_msgs::MachineState& machine);
/// Whether a job has ended by that state.
bool isEnd(const lamina_msgs::MachineState& machine);

}  // namespace lamina
