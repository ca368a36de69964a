// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "subcommand.hpp"

namespace lamina::cli {

// Subcommands in an executable of their own beside this one: the libraries that `lamina-optimise` searches
// with, `lamina-estimate` reads bags with, `lamina-journal` the database of a cell, and `lamina-token` keeps
// tokens with, take longer to load than most commands run.

/// Adds what `lamina --help` says of them.
void addSeparateCommands(CLI::App& app, Chosen& chosen);

/// Runs the executable in place of this process if the arguments name one of them; returns if they do not.
/// @throws FileError if it cannot be run
void runSeparateCommand(int argc, char** argv);

}  // namespace lamina::cli
