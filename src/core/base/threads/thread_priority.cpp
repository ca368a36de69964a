// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/threads/thread_priority.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace lamina {
namespace {

/// What sched_setattr takes in its first version; the C library has no name for it, and the kernel's header
/// cannot be included beside the C library's.
struct SchedulingAttributes {
  std::uint32_t size = sizeof(SchedulingAttributes);
  std::uint32_t policy = 0;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime = 0;  ///< [ns]
  std::uint64_t deadline = 0;
  std::uint64_t period = 0;
};

/// A thread that asks for short turns gets them sooner: from Linux 6.12 on, for ordinary threads too, and
/// without any right. Earlier kernels leave it without effect.
void askForShortTurns() {
  constexpr std::uint64_t kTurn = 100'000;  // ns, the shortest that the kernel knows
  SchedulingAttributes attributes;
  if (::syscall(SYS_sched_getattr, 0, &attributes, sizeof attributes, 0) != 0) return;
  if (attributes.policy != SCHED_OTHER) return;
  attributes.size = sizeof attributes;
  attributes.runtime = kTurn;
  ::syscall(SYS_sched_setattr, 0, &attributes, 0);
}

/// A better nice value, as far as the user's limit goes.
void askForNiceness() {
  constexpr int kBestNice = -10;
  rlimit limit{};
  // The limit is 20 - nice; a thread is a process to setpriority.
  if (::getrlimit(RLIMIT_NICE, &limit) != 0 || limit.rlim_cur == 0) return;
  const int allowed = 20 - static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 40));
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), std::max(kBestNice, allowed));
}

}  // namespace

bool preferThisThread() {
  sched_param parameters{};
  parameters.sched_priority = sched_get_priority_min(SCHED_RR);
  if (::pthread_setschedparam(::pthread_self(), SCHED_RR, &parameters) == 0) return true;
  askForNiceness();
  askForShortTurns();
  return false;
}

}  // namespace lamina
