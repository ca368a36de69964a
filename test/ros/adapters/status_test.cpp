// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "status.hpp"

#include <gtest/gtest.h>

namespace {

using lamina::ErrorCode;
using lamina::Failure;
using lamina_msgs::Status;

std::uint8_t statusNumber(ErrorCode code) { return static_cast<std::uint8_t>(code); }

TEST(Status, HasTheNumbersOfTheErrorCodes) {
  EXPECT_EQ(statusNumber(ErrorCode::Ok), Status::OK + 0);
  EXPECT_EQ(statusNumber(ErrorCode::Internal), Status::INTERNAL + 0);
  EXPECT_EQ(statusNumber(ErrorCode::InvalidInput), Status::INVALID_INPUT + 0);
  EXPECT_EQ(statusNumber(ErrorCode::InvalidMesh), Status::INVALID_MESH + 0);
  EXPECT_EQ(statusNumber(ErrorCode::InvalidConfig), Status::INVALID_CONFIG + 0);
  EXPECT_EQ(statusNumber(ErrorCode::InvalidProgram), Status::INVALID_PROGRAM + 0);
  EXPECT_EQ(statusNumber(ErrorCode::FileError), Status::FILE_ERROR + 0);
  EXPECT_EQ(statusNumber(ErrorCode::Unreachable), Status::UNREACHABLE + 0);
  EXPECT_EQ(statusNumber(ErrorCode::DeviceError), Status::DEVICE_ERROR + 0);
  EXPECT_EQ(statusNumber(ErrorCode::Disconnected), Status::DISCONNECTED + 0);
  EXPECT_EQ(statusNumber(ErrorCode::Rejected), Status::REJECTED + 0);
  EXPECT_EQ(statusNumber(ErrorCode::TimedOut), Status::TIMED_OUT + 0);
  EXPECT_EQ(statusNumber(ErrorCode::Cancelled), Status::CANCELLED + 0);
}

TEST(Status, CarriesAFailureThereAndBack) {
  const Failure failure =
      lamina::fromMessage(lamina::toMessage(Failure{ErrorCode::Rejected, "line 7: resend"}));
  EXPECT_EQ(failure.code, ErrorCode::Rejected);
  EXPECT_EQ(failure.message, "line 7: resend");
}

TEST(Status, OfAnUnknownNumberIsRefused) {
  Status status;
  status.code = 99;
  EXPECT_THROW(lamina::fromMessage(status), lamina::InvalidInput);
}

TEST(Status, ThrowsOnlyIfItReportsOfAFailure) {
  EXPECT_NO_THROW(lamina::throwIfFailed(Status()));
  Status status;
  status.code = Status::TIMED_OUT;
  status.message = "no ok for 5 s";
  try {
    lamina::throwIfFailed(status);
    FAIL() << "a failure must throw";
  } catch (const lamina::Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::TimedOut);
    EXPECT_STREQ(error.what(), "no ok for 5 s");
  }
}

}  // namespace
