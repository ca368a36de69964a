// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/control/program/planned_correction.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina::test {

/// What the record in a folder says that its program was corrected by.
inline PlannedCorrection recordedIn(const std::string& folder, const LoopSettings& feeding = {}) {
  return {readProgrammedToolpath(readFile(folder + "/" + kProgrammedToolpathFile), kProgrammedToolpathFile),
          readCorrectionFiles(folder), feeding, true};
}

/// What a program pushes forth in all [mm].
inline double filamentOf(const std::string& program) {
  double sum = 0.0;
  GcodeHandlers handlers;
  handlers.motion = [&](const GcodeMotion& motion) { sum += motion.extrusion_mm; };
  GcodeReader reader({}, handlers);
  reader.read(program);
  reader.finish();
  return sum;
}

}  // namespace lamina::test
