// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace lamina {

/// SIGINT, SIGTERM and SIGHUP, held back from the calling thread while this lives, so that none gets lost
/// between two looks. Made and ended by the same thread. Without a handler such a signal ends the process as
/// ever, at the next look.
class HeldSignals {
 public:
  HeldSignals();
  /// Signals that came since the last look reach their handlers.
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Whether a signal has come since the last look; its handler has then run.
  bool haveCome() const;

  /// The signals that the thread held back before: those to be held back while something is waited for.
  const sigset_t& before() const { return before_; }

 private:
  sigset_t before_{};
};

}  // namespace lamina
