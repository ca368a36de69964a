// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The rest of a program, from the line on that a machine has lost.
#include "job/settings/setting_probe.hpp"
#include "lamina/streaming/resume/remaining_program.hpp"

namespace lamina::test {
namespace {

// Of its nine lines the last two are left. The part reaches from 20 to 40 mm, and up to z = 0.4 mm.
constexpr char kLostJob[] =
    "M140 S60\nM104 S210\nG28\nG1 X20 Y20 Z0.2 F3000\nG1 X40 E3 F1200\nG1 Y40 E4\nG1 Z0.4\nG1 X20 E5\n"
    "G1 Y20 E6\n";

std::string restOfLostJob(const SettingTexts& set) {
  std::string rest;
  writeRemaining(StreamableProgram::fromText("lost", kLostJob), 8, 50.0, settingsWith<ResumeSettings>(set),
                 [&](std::string_view piece) { rest += piece; });
  return rest;
}

}  // namespace

std::vector<SettingProbe> resumeProbes() {
  // A filament of 2 mm has pi mm2: 10 mm of it are purged.
  return {{"the rest of a program",
           "resume.filament_diameter_mm=2;resume.purge_mm3=31.41592653589793",
           restOfLostJob,
           {{"resume.purge_mm3=62.83185307179586"},
            {"resume.purge_at_mm=-7,3"},
            {"resume.clearance_mm=10"},
            {"resume.tool_axis=0,-1,1"},
            {"resume.ramp_mm=30"},
            {"resume.filament_diameter_mm=4"},
            {"resume.retraction_mm=3"},
            {"resume.travel_feed_mm_s=30"},
            {"resume.purge_feed_mm_s=1"}}}};
}

}  // namespace lamina::test
