// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/characters.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace lamina {
namespace {

TEST(Characters, AreOfOneKindAtMost) {
  for (int code = -128; code < 128; ++code) {
    const char c = static_cast<char>(code);
    EXPECT_EQ(isDigit(c), code != 0 && std::string_view("0123456789").find(c) != std::string_view::npos);
    EXPECT_LE(int{isDigit(c)} + int{isLetter(c)} + int{isBlank(c)}, 1) << code;
  }
}

TEST(Characters, ChangeTheirCaseIfTheyAreLetters) {
  for (int code = -128; code < 128; ++code) {
    const char c = static_cast<char>(code);
    EXPECT_EQ(upper(c) != c || lower(c) != c, isLetter(c)) << code;
    if (isLetter(c)) {
      EXPECT_EQ(upper(lower(c)), upper(c)) << code;
    }
  }
  EXPECT_EQ(upper('m'), 'M');
  EXPECT_EQ(lower('Z'), 'z');
}

}  // namespace
}  // namespace lamina
