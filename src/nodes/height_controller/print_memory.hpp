// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/control/run/loop_run.hpp"

namespace lamina {

/// What the loop knows of the print under way, in a file from which another node can go on. A file that
/// cannot be written is reported once, and the print goes on.
class PrintMemory {
 public:
  /// @param file  empty keeps nothing
  explicit PrintMemory(std::string file) : file_(std::move(file)) {}

  bool isKept() const { return !file_.empty(); }

  /// Goes on with the print as the file has it; without one, or one that is of another print, from the first
  /// layer on, as the log then says.
  void resume(LoopRun& run);
  /// The layer that a print went on after; none if it did not.
  const std::optional<std::size_t>& resumedAfter() const { return resumed_after_; }

  /// The conditions that stood when a node before this one wrote the file; none if it cannot be read.
  std::vector<RaisedAlarm> stood() const;

  void keep(const LoopMemory& memory);
  /// What the operator asked for holds after a restart as well.
  void keepStatus(const LoopStatus& status);
  /// The conditions that stand, which may begin and end amid a layer; written if they have changed.
  void keepStanding(const std::vector<RaisedAlarm>& standing);
  /// The print is over.
  void forget();

 private:
  void write();

  std::string file_;
  std::optional<LoopMemory> memory_;
  std::optional<std::size_t> resumed_after_;
  bool has_failed_ = false;
};

}  // namespace lamina
