// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "messages.hpp"

namespace lamina {

/// Decides from the states of a machine whether it begins another part of the same toolpath or resumes an
/// interrupted job. Executors may print a toolpath several times, and it is not announced again.
class PartWatch {
 public:
  /// States that a part begins, and forgets the end of the previous part.
  void begin() { *this = {}; }

  /// Takes a state of the machine. A job that begins after a complete job is another part. After an
  /// interrupted job it is another part if it begins at a lower layer: below the layer that the machine
  /// stated at the end, or at least two below, since a machine states its layers late.
  /// @param layer  layer at which the nozzle was last seen
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
  std::optional<End> end_;  ///< end of the last job; nothing once a job resumes
};

/// Whether a job is under way in that state.
bool isUnderWay(const lamina_msgs::MachineState& machine);
/// Whether that state is the end of a job.
bool isEnd(const lamina_msgs::MachineState& machine);

}  // namespace lamina
