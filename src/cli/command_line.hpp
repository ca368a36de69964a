// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "subcommand.hpp"

namespace lamina::cli {

using AddSubcommand = void (*)(CLI::App& app, Chosen& chosen);

/// Runs the subcommand that the arguments name, of those given. Never throws but for want of memory.
/// @return the exit code of the process
int runCommandLine(int argc, char** argv, const std::vector<AddSubcommand>& subcommands);

}  // namespace lamina::cli
