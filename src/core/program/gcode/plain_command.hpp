// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace lamina {

/// Whether a line is a command as only G-code has it: G or M with its number, then nothing but letters with
/// numbers, and the flags X, Y, Z and E. Readers know a program by it (`Quotation`); commands that carry free
/// text are none.
bool isPlainCommand(std::string_view line);

}  // namespace lamina
