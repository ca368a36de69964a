// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/text_search.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(TextSearch, FindsWhatATextBeginsWith) {
  EXPECT_TRUE(startsWith("ok T:20", "ok"));
  EXPECT_TRUE(startsWith("ok", "ok"));
  EXPECT_TRUE(startsWith("ok", ""));
  EXPECT_FALSE(startsWith("o", "ok"));
  EXPECT_FALSE(startsWith("not ok", "ok"));
}

TEST(TextSearch, FindsAPartAnywhere) {
  EXPECT_TRUE(contains("not ok", "ok"));
  EXPECT_FALSE(contains("not", "ok"));
}

}  // namespace
}  // namespace lamina
