// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"

namespace lamina {

/// What a program is run with.
struct ProgramCall {
  std::vector<std::string> arguments;  ///< the first is the program, looked for in PATH if it has no slash
  std::string folder;                  ///< it runs in; empty for the current one
  double time_limit_s = 3600.0;
  std::string scratch = {};  ///< a folder that is removed if this process is killed meanwhile; empty: none
};

/// What a program left behind.
struct ProgramEnd {
  int exit_code = 0;  ///< 128 + the signal if one ended it
  std::string output;
  std::string errors;  ///< what it wrote on standard error
};

/// Runs a program without a shell, with nothing on its standard input, and waits for its end. It leads a
/// process group of its own: what it started and left running ends with it, and Ctrl-C on the terminal
/// reaches it only through `progress`. If this process is killed, a shell that waits for that ends the group.
/// @throws InvalidConfig if there are no arguments, or a text holds a zero byte; FileError if it cannot be
///   started, or its exit code is not to be had because this process ignores SIGCHLD; TimedOut if it runs
///   longer than it may; InvalidInput if it writes more than 64 MB; Cancelled. It has ended when this throws:
///   asked to (SIGTERM), and 2 s later not asked (SIGKILL).
ProgramEnd runProgram(const ProgramCall& call, const Progress& progress);

/// Path of a program in the folder of the running one: its own name leads to itself. If there is none, the
/// name, which PATH may know.
std::string siblingProgram(const std::string& name);

}  // namespace lamina
