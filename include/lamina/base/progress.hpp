// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Interface through which long work reports its progress, and learns that it should stop. Both calls may
/// come from any thread; `report` should return at once.
class Progress {
 public:
  virtual ~Progress() = default;

  /// @param stage     what is being done, in one or two words ("slice", "plan")
  /// @param fraction  completed share of this stage, 0 to 1
  virtual void report(const std::string& stage, double fraction) = 0;

  virtual bool isCancelled() const = 0;
};

/// Progress that ignores all reports and is never cancelled.
class NoProgress final : public Progress {
 public:
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return false; }
};

/// @throws Cancelled if `progress` is cancelled, naming the stage
void throwIfCancelled(const Progress& progress, const std::string& stage);

}  // namespace lamina
