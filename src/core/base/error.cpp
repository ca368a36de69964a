// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/error.hpp"

#include <new>

namespace lamina {

const char* toString(ErrorCode code) {
  switch (code) {
    case ErrorCode::Ok:
      return "Ok";
    case ErrorCode::Internal:
      return "Internal";
    case ErrorCode::InvalidInput:
      return "InvalidInput";
    case ErrorCode::InvalidMesh:
      return "InvalidMesh";
    case ErrorCode::InvalidConfig:
      return "InvalidConfig";
    case ErrorCode::InvalidProgram:
      return "InvalidProgram";
    case ErrorCode::FileError:
      return "FileError";
    case ErrorCode::Unreachable:
      return "Unreachable";
    case ErrorCode::DeviceError:
      return "DeviceError";
    case ErrorCode::Disconnected:
      return "Disconnected";
    case ErrorCode::Rejected:
      return "Rejected";
    case ErrorCode::TimedOut:
      return "TimedOut";
    case ErrorCode::Cancelled:
      return "Cancelled";
  }
  return "Unknown";
}

namespace {

/// Never empty, or a failure would look like none.
std::string messageOf(const std::exception& error) {
  const std::string message = error.what();
  return message.empty() ? "an exception without a message" : message;
}

}  // namespace

Failure currentFailure() {
  try {
    throw;
  } catch (const Error& error) {
    return {error.code(), messageOf(error)};
  } catch (const std::bad_alloc&) {
    return {ErrorCode::Internal, "out of memory"};
  } catch (const std::exception& error) {
    return {ErrorCode::Internal, messageOf(error)};
  } catch (...) {
    return {ErrorCode::Internal, "an exception of unknown type"};
  }
}

}  // namespace lamina
