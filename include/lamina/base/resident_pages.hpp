// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Gives back the memory of what the program and its libraries have mapped of their files and cannot write:
/// code, constants, and the names by which they were loaded. What is used again is mapped again from the
/// system's cache of files, so that what only the start used takes no memory during the work after it. Code
/// stays in a process that is being debugged, as debuggers write into it.
///
/// For once before long work, from any thread: the process does not change but in what it holds.
///
/// @return bytes that may have been in memory, and are not until they are used
std::size_t releaseStartPages();

}  // namespace lamina
