// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"

namespace lamina {

/// How a program is run.
struct ProgramCall {
  std::vector<std::string> arguments;  ///< the first is the program, searched for in PATH if it has no slash
  std::string folder;                  ///< working directory; empty for the present one
  double time_limit_s = 3600.0;
  std::string scratch = {};  ///< folder that is removed if this process is killed meanwhile; empty: none
};

/// The result of a program that has ended.
struct ProgramEnd {
  int exit_code = 0;   ///< 128 + number of the signal if a signal ended it
  std::string output;  ///< what it wrote on standard output
  std::string errors;  ///< what it wrote on standard error
};

/// Runs a program without a shell, with empty standard input, and waits for its end. The program leads a
/// process group of its own: processes that it has started and left running end with it, and Ctrl-C on the
/// terminal reaches it only through `progress`. If this process is killed, a watchdog shell kills the group.
///
/// If this function throws, the program has ended: it is sent SIGTERM, and SIGKILL 2 s later.
/// @throws InvalidConfig if there are no arguments, or one contains a zero byte
/// @throws FileError if it cannot be started, or its exit code is not available because this process ignores
///   SIGCHLD
/// @throws TimedOut if it runs longer than `time_limit_s`
/// @throws InvalidInput if it writes more than 64 MB
/// @throws Cancelled if `progress` is cancelled
ProgramEnd runProgram(const ProgramCall& call, const Progress& progress);

/// Path of a program in the folder of the running program; the name of the running program gives its own
/// path. If the folder has no such program, the result is the name, to be searched for in PATH.
std::string siblingProgram(const std::string& name);

}  // namespace lamina
