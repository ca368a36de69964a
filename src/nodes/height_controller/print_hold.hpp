// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <future>
#include <string>

namespace lamina {

/// Holds the print by the service `pause`. What does not answer is not waited for longer than `kPatience`:
/// the loop goes on.
class PrintHold {
 public:
  static constexpr double kPatience = 1.0;  ///< s

  /// @return what became of it, for the log
  std::string hold();

 private:
  std::future<std::string> asked_;
};

}  // namespace lamina
