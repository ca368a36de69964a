// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

/// Throws the error that a failure stands for: the kind of its code, with its message. A failure without
/// error, `Ok`, is Internal.
[[noreturn]] void throwFailure(const Failure& failure);

/// Throws the exception being handled again with the place in front of its message: "layer 12 at 2.4 mm:
/// ...". Its code stays; what it carries besides, as `Unsliceable` its region, is lost. `Cancelled` stays as
/// it is; what is no `Error` becomes Internal. Call inside a catch block only.
[[noreturn]] void rethrowAt(const std::string& place);

}  // namespace lamina
