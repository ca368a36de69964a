// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/threads/held_signals.hpp"

#include <poll.h>
#include <pthread.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>

namespace lamina {
namespace {

constexpr std::array<int, 3> kHeld = {SIGINT, SIGTERM, SIGHUP};

}  // namespace

HeldSignals::HeldSignals() {
  sigset_t held;
  sigemptyset(&held);
  for (const int signal : kHeld) sigaddset(&held, signal);
  ::pthread_sigmask(SIG_BLOCK, &held, &before_);
}

HeldSignals::~HeldSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

bool HeldSignals::haveCome() const {
  sigset_t pending;
  if (::sigpending(&pending) != 0) return false;
  const auto came = [&](int signal) {
    return sigismember(&pending, signal) == 1 && sigismember(&before_, signal) == 0;
  };
  if (std::none_of(kHeld.begin(), kHeld.end(), came)) return false;
  // Lets them through for no time at all; what is ignored does not end the wait.
  constexpr timespec kAtOnce{0, 0};
  return ::ppoll(nullptr, 0, &kAtOnce, &before_) < 0 && errno == EINTR;
}

}  // namespace lamina
