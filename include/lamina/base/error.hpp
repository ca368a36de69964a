// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace lamina {

// Error                    everything the core throws
// ├─ InvalidInput          a value, file or request that cannot be used
// │  ├─ InvalidMesh        names the defect and where it is
// │  ├─ InvalidConfig      names key, value and bound
// │  └─ InvalidProgram     names the line of the G-code
// ├─ FileError             a file that cannot be read or written
// ├─ Unreachable           a part or pose outside the machine
// ├─ DeviceError           the machine at the other end of a link
// │  ├─ Disconnected
// │  ├─ Rejected
// │  └─ TimedOut
// └─ Cancelled             somebody asked for it

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

/// Base of everything the core throws. The message says what, the actual value with its unit, and what was
/// expected.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

/// A kind of error: a leaf or branch of the tree above. `Base` is its parent in the tree.
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

/// A failure as a value: the code and the sentence of any exception. Anything that is no `Error` is
/// `Internal`.
struct Failure {
  ErrorCode code = ErrorCode::Ok;
  std::string message;
};

/// The failure that the exception being handled stands for. Call inside a catch block only.
Failure currentFailure();

}  // namespace lamina
