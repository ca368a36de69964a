// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>

namespace lamina {

/// Holds the print by the service `pause`. An answer is awaited for `kPatience` at most: the loop continues.
/// A later answer is passed on. If it is a refusal, a hold that was requested meanwhile is requested again.
class PrintHold {
 public:
  static constexpr double kPatience = 1.0;  ///< s

  /// Outcome of a request.
  struct Answer {
    bool is_held = false;
    std::string text;         ///< for the log
    bool is_passing = false;  ///< whether it was refused in a temporary state
  };
  /// Requests a hold and waits for the answer, in a thread of its own.
  using Ask = std::function<Answer()>;

  /// Holds by the unit of the cell if there is one, otherwise by the executor.
  PrintHold();
  explicit PrintHold(Ask ask) : ask_(std::move(ask)) {}

  /// @return outcome, for the log
  std::string hold();
  /// States that the print is over, or its loop is off: no hold is requested again.
  void release();
  /// The outcome of a request for which `hold` did not wait, once it is known. A request refused in a
  /// temporary state is repeated, and reported once for each reason.
  std::optional<std::string> takeLate();

 private:
  Ask ask_;
  std::future<Answer> asked_;
  bool is_wanted_ = false;
  std::string waits_for_;         ///< why the unit takes no Hold yet, as reported
  bool is_wanted_again_ = false;  ///< whether `hold` was called while a request was under way
};

}  // namespace lamina
