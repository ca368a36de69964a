// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// How what a node was asked for has ended.
struct RunOutcome {
  enum class End { Done, Stopped, Failed };
  End end = End::Failed;
  std::string message;  ///< for the person: what was done, or why not
  std::string output;   ///< the file that was written; empty unless one was
};

}  // namespace lamina
