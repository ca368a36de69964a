// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Which of the nozzle's frames along a toolpath are shown.
struct FrameSettings {
  double every_mm = 0.0;   ///< length of toolpath between one frame and the next; 0 shows none
  double length_mm = 2.0;  ///< of the axes of a frame
};

/// Adds the keys frames.*.
void describe(SettingsSchema& schema, FrameSettings& settings);

}  // namespace lamina
