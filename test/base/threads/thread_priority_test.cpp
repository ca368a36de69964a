// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/threads/thread_priority.hpp"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <thread>

namespace lamina {
namespace {

bool isLinuxFrom(int major, int minor) {
  utsname system{};
  ::uname(&system);
  int is_major = 0;
  int is_minor = 0;
  return std::sscanf(system.release, "%d.%d", &is_major, &is_minor) == 2 &&
         std::pair(is_major, is_minor) >= std::pair(major, minor);
}

/// The calling thread may no longer raise its priority beyond the user's limits.
void giveUpRights() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, 2> rights{};
  ::syscall(SYS_capget, &header, rights.data());
  rights[0].effective &= ~(1U << CAP_SYS_NICE);
  ::syscall(SYS_capset, &header, rights.data());
}

/// How long the turns of the calling thread are [ns].
std::uint64_t turn() {
  std::array<char, 48> attributes{};
  ::syscall(SYS_sched_getattr, 0, attributes.data(), attributes.size(), 0);
  std::uint64_t runtime = 0;
  std::memcpy(&runtime, attributes.data() + 24, sizeof runtime);
  return runtime;
}

TEST(ThreadPriority, GivesAnyUsersThreadShortTurns) {
  rlimit limit{};
  ::getrlimit(RLIMIT_RTPRIO, &limit);
  if (limit.rlim_cur > 0) GTEST_SKIP() << "this user may ask for real time";
  if (!isLinuxFrom(6, 12)) GTEST_SKIP() << "this kernel gives ordinary threads no turns of their own";
  std::thread([] {
    giveUpRights();
    preferThisThread();
    EXPECT_EQ(::sched_getscheduler(0), SCHED_OTHER);
    EXPECT_EQ(turn(), 100'000U);
  }).join();
}

}  // namespace
}  // namespace lamina
