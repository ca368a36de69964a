// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/correction_options.hpp"

namespace lamina::cli {

void addToolpathOption(CLI::App& subcommand, CorrectionFiles& files) {
  subcommand.add_option("--toolpath", files.toolpath,
                        "toolpath (.csv) that the maps are of, as it stands beside maps; without it, "
                        "toolpath.csv beside these");
}

}  // namespace lamina::cli
