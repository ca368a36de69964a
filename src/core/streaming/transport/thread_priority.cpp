// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/transport/thread_priority.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

namespace lamina {

void preferThisThread() {
  sched_param parameters{};
  parameters.sched_priority = sched_get_priority_min(SCHED_RR);
  if (::pthread_setschedparam(::pthread_self(), SCHED_RR, &parameters) == 0) return;
  constexpr int kBestNice = -10;
  rlimit limit{};
  // The limit is 20 - nice; a thread is a process to setpriority.
  if (::getrlimit(RLIMIT_NICE, &limit) != 0 || limit.rlim_cur == 0) return;
  const int allowed = 20 - static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 40));
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), std::max(kBestNice, allowed));
}

}  // namespace lamina
