// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "subcommand.hpp"

namespace lamina::cli {

/// A subcommand and its name. An entry for several subcommands, which `lamina --help` lists, has no name.
struct Subcommand {
  const char* name;
  void (*add)(CLI::App& app, Chosen& chosen);
};

/// The arguments, `lamina help slice` read as `lamina slice --help`.
std::vector<std::string> withHelpAsOption(std::vector<std::string> arguments);

/// The first argument that is neither an option before the subcommand nor its value; empty if there is none.
std::string subcommandOf(int argc, char** argv);

/// Runs the one of the given subcommands that the arguments name. Options of the others are not set up, to
/// save memory. Throws only if memory is exhausted.
/// @return the exit code of the process
int runCommandLine(int argc, char** argv, const std::vector<Subcommand>& subcommands);

}  // namespace lamina::cli
