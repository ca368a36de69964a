// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/gcode_rewrite/rewrite_settings.hpp"

namespace lamina {

/// Whether E is absolute. G90 and G91 say it too for Marlin, and do not for RepRapFirmware and Klipper; what
/// firmwares read differently is disputed.
class ExtrusionModeState {
 public:
  explicit ExtrusionModeState(std::optional<ExtrusionMode> initial)
      : stated_(initial.value_or(ExtrusionMode::Absolute)),
        marlin_(stated_),
        is_known_(initial.has_value()) {}

  void state(ExtrusionMode mode) {
    stated_ = marlin_ = mode;
    is_known_ = true;
    is_declared_ = false;
  }
  void positionMode(ExtrusionMode mode) {
    if (!is_declared_) marlin_ = mode;
  }
  /// What was said on the command line holds whatever G90 and G91 mean.
  void declare() { is_declared_ = is_known_; }

  bool isDisputed() const { return stated_ != marlin_; }
  bool isKnown() const { return is_known_; }  ///< said by M82, M83 or the user
  ExtrusionMode mode() const { return stated_; }

 private:
  ExtrusionMode stated_;
  ExtrusionMode marlin_;
  bool is_known_;
  bool is_declared_ = false;
};

}  // namespace lamina
