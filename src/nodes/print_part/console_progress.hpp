// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Progress on the terminal: one line, redrawn in place, or a line for every tenth if standard output is no
/// terminal.
class ConsoleProgress {
 public:
  ConsoleProgress();

  /// @param fraction  of this stage, 0 to 1
  /// @param detail    behind the bar; may be empty
  void show(const std::string& stage, double fraction, const std::string& detail);

  /// Ends the line that is being redrawn.
  void finish();

 private:
  bool is_terminal_;
  std::string drawn_;
};

}  // namespace lamina
