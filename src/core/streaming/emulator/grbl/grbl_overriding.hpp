// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

namespace lamina {

/// Overrides in grbl's way: bytes set flags as they arrive, and the flags take effect when grbl looks at
/// them.
class GrblOverriding {
 public:
  const GrblPercents& percents() const { return percents_; }

  /// Receives a byte.
  /// @return whether it is a byte for an override, and so not kept in the receive buffer
  bool note(char byte);
  /// Applies the bytes that have arrived since the last call.
  void apply();
  /// Resets all overrides, as at a restart.
  void reset();
  /// The part of a report that states the overrides: "|Ov:100,100,100" in one of ten reports and in the next
  /// one after a change, otherwise empty.
  std::string takeReport();

 private:
  GrblPercents percents_;
  std::set<char> bytes_;  ///< bytes since the last `apply`; equal ones count once
  int reports_left_ = 1;  ///< number of reports until overrides are reported again
};

}  // namespace lamina
