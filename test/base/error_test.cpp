// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/error.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace lamina {
namespace {

Failure failureOf(const std::function<void()>& act) {
  try {
    act();
  } catch (...) {
    return currentFailure();
  }
  return {};
}

TEST(Error, CarriesItsCodeAndSentence) {
  const InvalidMesh error("edge 3-4 is open");
  EXPECT_EQ(error.code(), ErrorCode::InvalidMesh);
  EXPECT_STREQ(error.what(), "edge 3-4 is open");
}

TEST(Error, IsCaughtAsTheBranchOfTheTreeItHangsOn) {
  EXPECT_THROW(throw InvalidMesh(""), InvalidInput);
  EXPECT_THROW(throw InvalidConfig(""), InvalidInput);
  EXPECT_THROW(throw InvalidProgram(""), InvalidInput);
  EXPECT_THROW(throw Disconnected(""), DeviceError);
  EXPECT_THROW(throw Rejected(""), DeviceError);
  EXPECT_THROW(throw TimedOut(""), DeviceError);
  EXPECT_THROW(throw Cancelled(""), Error);
  EXPECT_THROW(throw FileError(""), std::runtime_error);
}

TEST(ErrorCode, HasANameOfItsOwn) {
  std::set<std::string> names;
  for (const ErrorCode code :
       {ErrorCode::Ok, ErrorCode::Internal, ErrorCode::InvalidInput, ErrorCode::InvalidMesh,
        ErrorCode::InvalidConfig, ErrorCode::InvalidProgram, ErrorCode::FileError, ErrorCode::Unreachable,
        ErrorCode::DeviceError, ErrorCode::Disconnected, ErrorCode::Rejected, ErrorCode::TimedOut,
        ErrorCode::Cancelled}) {
    EXPECT_STRNE(toString(code), "Unknown");
    EXPECT_TRUE(names.insert(toString(code)).second) << toString(code);
  }
}

TEST(CurrentFailure, KeepsCodeAndSentenceOfAnError) {
  const Failure failure = failureOf([] { throw TimedOut("no answer in 5 s"); });
  EXPECT_EQ(failure.code, ErrorCode::TimedOut);
  EXPECT_EQ(failure.message, "no answer in 5 s");
}

TEST(CurrentFailure, IsInternalForAnythingElse) {
  EXPECT_EQ(failureOf([] { throw std::logic_error("bug"); }).message, "bug");
  EXPECT_EQ(failureOf([] { throw std::logic_error("bug"); }).code, ErrorCode::Internal);
  EXPECT_EQ(failureOf([] { throw std::bad_alloc(); }).message, "out of memory");
  EXPECT_EQ(failureOf([] { throw 3; }).code, ErrorCode::Internal);
}

}  // namespace
}  // namespace lamina
