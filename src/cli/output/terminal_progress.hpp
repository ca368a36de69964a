// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

#include "lamina/base/progress.hpp"

namespace lamina::cli {

/// Progress on the terminal: one line on standard error, redrawn in place; silent where standard error is no
/// terminal. Ctrl-C (SIGINT) and SIGTERM cancel the work during the object's lifetime. At most one object at
/// a time.
class TerminalProgress final : public Progress {
 public:
  TerminalProgress();
  ~TerminalProgress() override;
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  void report(const std::string& stage, double fraction) override;
  bool isCancelled() const override;

 private:
  std::mutex mutex_;
  bool is_shown_;
  std::string drawn_;
};

}  // namespace lamina::cli
