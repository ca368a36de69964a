// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// A source's report of an alarm.
struct ReportedCause {
  int id = 0;
  std::string source;
  double value = 0.0;
  std::string message;
};

/// Which sources report the cause of each alarm as present. Several sources may raise one alarm, each with a
/// cause of its own: the alarm ends when all causes have ended.
class AlarmSources {
 public:
  /// What the end of a cause means for the alarm.
  struct End {
    bool is_over = false;                ///< whether nobody reports a cause any more
    std::optional<ReportedCause> other;  ///< cause to show from now on; nothing if the shown one remains
  };

  /// A source reports a cause, which replaces its earlier cause of the alarm.
  void raise(ReportedCause cause);
  /// A source reports its cause as gone.
  /// @return nothing if the source has reported none
  std::optional<End> end(int id, const std::string& source);
  /// Whether anybody reports a cause of that alarm.
  bool isRaised(int id) const;

 private:
  std::vector<ReportedCause> causes_;  ///< the latest last
};

}  // namespace lamina
