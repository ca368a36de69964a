// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace lamina {

/// Whether a line is a command of a form that only G-code has: G or M with its number, then only letters with
/// numbers and the flags X, Y, Z and E. Readers recognise a program by such a line (`Quotation`). Commands
/// with free text do not count.
bool isPlainCommand(std::string_view line);

}  // namespace lamina
