// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace lamina::cli {

/// What a subcommand does once the arguments are read. Throws on failure; the caller prints the error and chooses the
/// exit code.
using Run = std::function<void()>;

/// Each adds its subcommand with all its options to `app`; when it is chosen on the command line, `run` is set.
/// `run` must outlive the parsing.
using AddSubcommand = void (*)(CLI::App& app, Run& run);

}  // namespace lamina::cli
