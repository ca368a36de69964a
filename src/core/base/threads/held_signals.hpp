// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace lamina {

/// SIGINT, SIGTERM and SIGHUP, held back from the calling thread during the object's lifetime: none is lost
/// between two calls of `haveCome`. Created and destroyed by the same thread. A signal without a handler ends
/// the process as usual, at the next call.
class HeldSignals {
 public:
  HeldSignals();
  /// Signals that came since the last call reach their handlers.
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Whether a signal has come since the last call; its handler has then run.
  bool haveCome() const;

  /// Signals that the thread held back before: the mask to be used during a wait.
  const sigset_t& before() const { return before_; }

 private:
  sigset_t before_{};
};

}  // namespace lamina
