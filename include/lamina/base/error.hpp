// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace lamina {

// Error                    everything that the core throws
// ├─ InvalidInput          a value, file or request that cannot be used
// │  ├─ InvalidMesh        names the defect and its position
// │  ├─ InvalidConfig      names key, value and bound
// │  └─ InvalidProgram     names the line of the G-code
// ├─ FileError             a file that cannot be read or written
// ├─ Unreachable           a part or pose outside the machine
// ├─ DeviceError           the machine at the other end of a link
// │  ├─ Disconnected
// │  ├─ Rejected
// │  └─ TimedOut
// └─ Cancelled             the work was cancelled on request

/// The number of each kind of error. `msg/Status.msg` holds the same numbers; a test compares them.
enum class ErrorCode : std::uint8_t {
  Ok = 0,
  Internal = 1,
  InvalidInput = 10,
  InvalidMesh = 11,
  InvalidConfig = 12,
  InvalidProgram = 13,
  FileError = 20,
  Unreachable = 30,
  DeviceError = 40,
  Disconnected = 41,
  Rejected = 42,
  TimedOut = 43,
  Cancelled = 50,
};

/// The code as written in messages and JSON: "InvalidMesh".
const char* toString(ErrorCode code);

/// Base of everything that the core throws. The message states what is wrong, the actual value with its unit,
/// and what was expected.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

/// A kind of error: a node of the tree above. `Base` is its parent in the tree.
template <ErrorCode kCode, class Base>
class ErrorOf : public Base {
 public:
  explicit ErrorOf(const std::string& message) : Base(kCode, message) {}

 protected:
  ErrorOf(ErrorCode code, const std::string& message) : Base(code, message) {}
  template <ErrorCode, class>
  friend class ErrorOf;
};

using InvalidInput = ErrorOf<ErrorCode::InvalidInput, Error>;
using InvalidMesh = ErrorOf<ErrorCode::InvalidMesh, InvalidInput>;
using InvalidConfig = ErrorOf<ErrorCode::InvalidConfig, InvalidInput>;
using InvalidProgram = ErrorOf<ErrorCode::InvalidProgram, InvalidInput>;
using FileError = ErrorOf<ErrorCode::FileError, Error>;
using Unreachable = ErrorOf<ErrorCode::Unreachable, Error>;
using DeviceError = ErrorOf<ErrorCode::DeviceError, Error>;
using Disconnected = ErrorOf<ErrorCode::Disconnected, DeviceError>;
using Rejected = ErrorOf<ErrorCode::Rejected, DeviceError>;
using TimedOut = ErrorOf<ErrorCode::TimedOut, DeviceError>;
using Cancelled = ErrorOf<ErrorCode::Cancelled, Error>;

/// A failure as a value: code and message of an exception. Any exception that is not an `Error` has the code
/// `Internal`.
struct Failure {
  ErrorCode code = ErrorCode::Ok;
  std::string message;
};

/// The exception that is being handled, as a failure. Call it only inside a catch block.
Failure currentFailure();

}  // namespace lamina
