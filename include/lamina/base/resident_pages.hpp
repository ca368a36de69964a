// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Releases the memory in which the files of the program and its libraries are mapped read-only: code,
/// constants and symbol names. Pages that are used again are mapped again from the system's file cache. Pages
/// that only the start needed take no memory during later work. Code stays in a process that is being
/// debugged, since debuggers write into it.
///
/// Meant to be called once before long work, from any thread; it changes nothing but the memory in use.
///
/// @return number of bytes that may have been in memory, and are not until they are used again
std::size_t releaseStartPages();

}  // namespace lamina
