// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/threads/periodic_thread.hpp"

#include <linux/capability.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "base/threads/thread_priority.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

timespec timeOf(double time_s) {
  const double whole = std::floor(time_s);
  return {static_cast<time_t>(whole), static_cast<long>(1e9 * (time_s - whole))};
}

/// Whether no limit holds for locked memory.
bool mayLockAll() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY) return true;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
  return ::syscall(SYS_capget, &header, sets.data()) == 0 && (sets[0].effective & 1U << CAP_IPC_LOCK) != 0;
}

/// A process that reaches a limit would get no memory any more: it locks none.
bool lockMemory() { return mayLockAll() && ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0; }

}  // namespace

PeriodicThread::PeriodicThread(double rate_hz, std::function<void(double due_s)> cycle)
    : period_s_(1.0 / rate_hz),
      cycle_(std::move(cycle)),
      timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC)),
      end_(::eventfd(0, EFD_CLOEXEC)) {
  if (timer_ < 0 || end_ < 0) throw DeviceError(std::string("no timer: ") + std::strerror(errno));
  // Before the first cycle: it takes a tenth of a second, in which the process's threads stand.
  is_memory_locked_ = lockMemory();
  thread_ = std::thread([this] { run(); });
}

PeriodicThread::~PeriodicThread() {
  const std::uint64_t one = 1;
  while (::write(end_, &one, sizeof one) < 0 && errno == EINTR) continue;
  thread_.join();
  ::close(timer_);
  ::close(end_);
}

std::string PeriodicThread::rights() {
  const std::string time = answer_.get() ? "in real time" : "without real time (ulimit -r)";
  return time + (is_memory_locked_ ? ", memory locked" : ", memory not locked (ulimit -l)");
}

void PeriodicThread::run() {
  is_real_time_.set_value(preferThisThread());
  double due_s = SteadyClock().now() + period_s_;
  const itimerspec times{timeOf(period_s_), timeOf(due_s)};
  ::timerfd_settime(timer_, TFD_TIMER_ABSTIME, &times, nullptr);
  for (;;) {
    std::array<pollfd, 2> ready = {{{timer_, POLLIN, 0}, {end_, POLLIN, 0}}};
    if (::poll(ready.data(), ready.size(), -1) < 0) continue;
    if (ready[1].revents != 0) return;
    std::uint64_t passed = 0;
    if (::read(timer_, &passed, sizeof passed) != sizeof passed) continue;
    cycle_(due_s);
    due_s += period_s_ * static_cast<double>(passed);
  }
}

}  // namespace lamina
