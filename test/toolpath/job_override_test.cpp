// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/job_override.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

TEST(OverrideKind, IsNamedAndBounded) {
  for (const double share : {0.1, 1.0, 3.0}) {
    EXPECT_EQ(overrideRefusal(OverrideKind::Feed, share, boundsOf(OverrideKind::Feed)), "");
    EXPECT_EQ(overrideRefusal(OverrideKind::Flow, share, boundsOf(OverrideKind::Flow)), "");
  }
  EXPECT_EQ(overrideRefusal(OverrideKind::Power, 2.5, boundsOf(OverrideKind::Power)),
            "power is 2.5; must be from 0.1 to 2, 1 is as planned");
  EXPECT_EQ(overrideRefusal(OverrideKind::Flow, 0.0, boundsOf(OverrideKind::Flow)),
            "flow is 0; must be from 0.1 to 3, 1 is as planned");
  EXPECT_NE(overrideRefusal(OverrideKind::Feed, std::nan(""), boundsOf(OverrideKind::Feed)), "");
}

}  // namespace
}  // namespace lamina
