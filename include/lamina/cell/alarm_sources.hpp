// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// What a source reports of an alarm.
struct ReportedCause {
  int id = 0;
  std::string source;
  double value = 0.0;
  std::string message;
};

/// Which sources report the cause of each alarm as present. Several may raise one alarm, each for a cause of
/// its own: it ends when it has ended for all of them.
class AlarmSources {
 public:
  /// What the end of a cause means for the alarm.
  struct End {
    bool is_over = false;                ///< whether nobody reports a cause any more
    std::optional<ReportedCause> other;  ///< to be shown from now on; nothing if what is shown remains
  };

  /// A source reports a cause; it replaces what it has reported before.
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
