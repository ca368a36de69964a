// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/job_override.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

TEST(JobOverride, IsNamedAndBounded) {
  for (const double share : {0.1, 1.0, 3.0}) {
    EXPECT_EQ(overrideRefusal(JobOverride::Feed, share, boundsOf(JobOverride::Feed)), "");
    EXPECT_EQ(overrideRefusal(JobOverride::Flow, share, boundsOf(JobOverride::Flow)), "");
  }
  EXPECT_EQ(overrideRefusal(JobOverride::Power, 2.5, boundsOf(JobOverride::Power)),
            "power is 2.5; must be from 0.1 to 2, 1 is as planned");
  EXPECT_EQ(overrideRefusal(JobOverride::Flow, 0.0, boundsOf(JobOverride::Flow)),
            "flow is 0; must be from 0.1 to 3, 1 is as planned");
  EXPECT_NE(overrideRefusal(JobOverride::Feed, std::nan(""), boundsOf(JobOverride::Feed)), "");
}

}  // namespace
}  // namespace lamina
