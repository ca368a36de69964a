// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "subcommand.hpp"

namespace lamina::cli {

void addJsonFlag(CLI::App& subcommand, Chosen& chosen) {
  subcommand.add_flag_callback(
      "--json", [&chosen] { chosen.format = OutputFormat::Json; },
      "Print one JSON object on standard output and nothing else there, also on failure");
}

}  // namespace lamina::cli
