// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/control/run/loop_run.hpp"

namespace lamina {

/// The loop's knowledge of the print under way, in a file from which a restarted node can continue. A file
/// that cannot be written is reported once, and the print continues.
class PrintMemory {
 public:
  /// @param file  empty keeps nothing
  explicit PrintMemory(std::string file) : file_(std::move(file)) {}

  bool isKept() const { return !file_.empty(); }

  /// Continues the print from the file. Without a file, or with one of another print, it begins with the
  /// first layer and logs this.
  void resume(LoopRun& run);
  /// The layer after which the print was continued; none if it was not.
  const std::optional<std::size_t>& resumedAfter() const { return resumed_after_; }

  /// The conditions that stood when a previous node wrote the file; none if the file cannot be read.
  std::vector<RaisedAlarm> stood() const;

  void keep(const LoopMemory& memory);
  /// Keeps the operator's requests, which hold after a restart as well.
  void keepStatus(const LoopStatus& status);
  /// Keeps the standing conditions, which may begin and end within a layer; written if they have changed.
  void keepStanding(const std::vector<RaisedAlarm>& standing);
  /// States that the print is over.
  void forget();

 private:
  void write();

  std::string file_;
  std::optional<LoopMemory> memory_;
  std::optional<std::size_t> resumed_after_;
  bool has_failed_ = false;
};

}  // namespace lamina
