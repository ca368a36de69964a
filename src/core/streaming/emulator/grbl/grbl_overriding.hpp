// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

namespace lamina {

/// Overrides as grbl takes them: flags that are set as bytes arrive, and obeyed when it looks at them.
class GrblOverriding {
 public:
  const GrblPercents& percents() const { return percents_; }

  /// Takes a byte that arrives.
  /// @return whether it does not wait in the buffer
  bool note(char byte);
  /// Obeys the bytes that came since it was called last.
  void apply();
  /// As after a restart.
  void reset();
  /// What a report says of them: "|Ov:100,100,100" in one of ten, and in the next one after a change.
  std::string takeReport();

 private:
  GrblPercents percents_;
  std::set<char> bytes_;  ///< that came since the firmware looked last; equal ones are one
  int reports_left_ = 1;  ///< until they are reported again
};

}  // namespace lamina
