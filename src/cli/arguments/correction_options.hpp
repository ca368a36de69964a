// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "lamina/job/corrected_job.hpp"

namespace lamina::cli {

/// Adds `--toolpath`.
void addToolpathOption(CLI::App& subcommand, CorrectionFiles& files);

}  // namespace lamina::cli
