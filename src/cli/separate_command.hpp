// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "subcommand.hpp"

namespace lamina::cli {

// Subcommands in separate executables beside this one: `lamina-optimise` (search), `lamina-estimate` (bags),
// `lamina-journal` (database of a cell) and `lamina-token` (tokens). Their libraries take longer to load than
// most commands run.

/// Adds the descriptions of these subcommands to `lamina --help`.
void addSeparateCommands(CLI::App& app, Chosen& chosen);

/// Runs the executable in place of this process if the arguments name one of them; returns if they do not.
/// @throws FileError if it cannot be run
void runSeparateCommand(int argc, char** argv);

}  // namespace lamina::cli
