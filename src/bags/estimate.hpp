// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "subcommand.hpp"

namespace lamina::cli {

/// Adds `lamina estimate`: the loop over a bag, without a master.
void addEstimate(CLI::App& app, Chosen& chosen);

}  // namespace lamina::cli
