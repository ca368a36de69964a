// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

namespace lamina {

/// Overrides as grbl implements them: a byte sets a flag when it arrives; `apply` carries out the flags.
class GrblOverriding {
 public:
  const GrblPercents& percents() const { return percents_; }

  /// Receives a byte.
  /// @return whether it is an override byte, which is not kept in the receive buffer
  bool note(char byte);
  /// Applies the bytes that have arrived since the last call.
  void apply();
  /// Resets all overrides, as at a restart.
  void reset();
  /// The part of a report that states the overrides: "|Ov:100,100,100" in one of ten reports and in the first
  /// report after a change, otherwise empty.
  std::string takeReport();

 private:
  GrblPercents percents_;
  std::set<char> bytes_;  ///< bytes since the last `apply`; equal bytes count once
  int reports_left_ = 1;  ///< number of reports until overrides are reported again
};

}  // namespace lamina
