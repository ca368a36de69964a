// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/upload_room.hpp"

#include <gtest/gtest.h>

#include "lamina/web/upload_file.hpp"

namespace lamina::test {
namespace {

constexpr std::uint64_t kSparedBytes = std::uint64_t{1} << 30;
constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;

TEST(UploadRoom, TakesBackWhatWasPromisedAndNotWritten) {
  std::uint64_t free_bytes = kSparedBytes + 100 * kMebibyte;
  UploadRoom room("/disk", [&](const std::string&) { return free_bytes; });
  auto first = room.reserve(40 * kMebibyte);
  ASSERT_TRUE(first);
  EXPECT_FALSE(room.reserve(11 * kMebibyte)) << "20 MiB are left for an upload and its copy";
  EXPECT_TRUE(room.reserve(10 * kMebibyte));
  first->note(10 * kMebibyte);
  free_bytes -= 10 * kMebibyte;
  EXPECT_FALSE(room.reserve(11 * kMebibyte)) << "what was written is no longer free";
  first.reset();
  EXPECT_TRUE(room.reserve(45 * kMebibyte));
}

TEST(UploadRoom, EndsAnUploadWhenSomethingElseFillsTheDisk) {
  std::uint64_t free_bytes = 3 * kSparedBytes;
  UploadRoom room("/disk", [&](const std::string&) { return free_bytes; });
  const auto place = room.reserve(500 * kMebibyte);
  ASSERT_TRUE(place);
  free_bytes = 2 * kSparedBytes;
  EXPECT_NO_THROW(place->note(16 * kMebibyte)) << "984 of 1024 MiB";
  free_bytes = 2 * kSparedBytes - 60 * kMebibyte;
  EXPECT_NO_THROW(place->note(16 * kMebibyte - 1)) << "not looked at";
  try {
    place->note(1);
    FAIL() << "968 MiB are promised, 964 are free";
  } catch (const UploadTooLarge& error) {
    EXPECT_EQ(error.status(), 507);
  }
}

}  // namespace
}  // namespace lamina::test
