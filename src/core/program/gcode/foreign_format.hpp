// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace lamina {

/// Refuses a file that somebody took for G-code and that is none: binary G-code, an archive, a compressed
/// file, text in UTF-16.
/// @param start  first bytes of the file, four or more of a file that has them
/// @param path  names the file in errors
/// @throws FileError that names the format, and how G-code is had instead
void requireTextOfGcode(std::string_view start, const std::string& path);

}  // namespace lamina
