// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/frame_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, FrameSettings& settings) {
  schema.number("frames.every_mm", settings.every_mm, {0.0, 1e6},
                "Way between the nozzle's frames that are shown; 0 shows none.");
  schema.number("frames.length_mm", settings.length_mm, Bounds::above(0.0, 1e3), "Length of a frame's axes.");
}

}  // namespace lamina
