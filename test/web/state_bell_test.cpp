// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/state_bell.hpp"

#include <gtest/gtest.h>
#include <poll.h>

#include <optional>
#include <thread>

namespace lamina {
namespace {

bool isRung(const StateBell::Ear& ear) {
  pollfd poll{ear.descriptor(), POLLIN, 0};
  return ::poll(&poll, 1, 0) == 1;
}

TEST(StateBell, IsHeardByAllUntilTheyClearIt) {
  StateBell bell;
  EXPECT_FALSE(bell.isHeard());
  bell.ring();  // by nobody
  std::optional<StateBell::Ear> first(std::in_place, bell);
  StateBell::Ear second(bell);
  EXPECT_TRUE(bell.isHeard());
  EXPECT_FALSE(isRung(*first));
  bell.ring();
  bell.ring();
  EXPECT_TRUE(isRung(*first));
  EXPECT_TRUE(isRung(second));
  first->clear();
  EXPECT_FALSE(isRung(*first)) << "of all rings at once";
  EXPECT_TRUE(isRung(second));
  first->clear();  // without a ring: does not wait
  first.reset();
  EXPECT_TRUE(bell.isHeard());
  bell.ring();
  EXPECT_TRUE(isRung(second));
}

TEST(StateBell, WakesAThreadThatWaits) {
  StateBell bell;
  StateBell::Ear ear(bell);
  std::thread ringer([&bell] { bell.ring(); });
  pollfd poll{ear.descriptor(), POLLIN, 0};
  EXPECT_EQ(::poll(&poll, 1, -1), 1);
  ringer.join();
}

}  // namespace
}  // namespace lamina
