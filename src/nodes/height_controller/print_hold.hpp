// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>

namespace lamina {

/// Holds the print by the service `pause`. What does not answer is not waited for longer than `kPatience`:
/// the loop goes on. An answer that comes later is passed on, and a hold that was asked for meanwhile is
/// asked for again if that answer was a refusal.
class PrintHold {
 public:
  static constexpr double kPatience = 1.0;  ///< s

  /// What became of a request.
  struct Answer {
    bool is_held = false;
    std::string text;         ///< for the log
    bool is_passing = false;  ///< whether it was refused in a state that passes
  };
  /// Asks for it and waits for the answer, on a thread of its own.
  using Ask = std::function<Answer()>;

  /// By the unit of the cell if there is one, else by the executor.
  PrintHold();
  explicit PrintHold(Ask ask) : ask_(std::move(ask)) {}

  /// @return what became of it, for the log
  std::string hold();
  /// The print that was to be held is over, or its loop is off: nothing is asked again.
  void release();
  /// What became of a request that `hold` did not wait for, once that is known. One that was refused in a
  /// state that passes is made again, and reported once for each reason.
  std::optional<std::string> takeLate();

 private:
  Ask ask_;
  std::future<Answer> asked_;
  bool is_wanted_ = false;
  std::string waits_for_;         ///< why the unit takes no Hold yet, as reported
  bool is_wanted_again_ = false;  ///< whether `hold` was called while a request was under way
};

}  // namespace lamina
