// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/program_check.hpp"

#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/kinematics/model/toolpath_reach.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina {
namespace {

constexpr double kTolerance = 1e-3;  // [mm]: digits of programs

std::string describeBox(const Box3& box) {
  char text[160];
  std::snprintf(text, sizeof text, "(%.1f, %.1f, %.1f) to (%.1f, %.1f, %.1f) mm", box.low.x(), box.low.y(),
                box.low.z(), box.high.x(), box.high.y(), box.high.z());
  return text;
}

std::string describePoint(const Point3& point) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f) mm", point.x(), point.y(), point.z());
  return text;
}

/// Why the tip is beyond the bounding box of the space; empty if it is not.
std::string faultByBox(const BuildSpace& space, const Box3& box, const Point3& tip) {
  const bool is_within = (tip.array() >= box.low.array() - kTolerance).all() &&
                         (tip.array() <= box.high.array() + kTolerance).all();
  return is_within ? "" : space.name + " reaches " + describeBox(box);
}

}  // namespace

std::string machineSheet(const MachineSettings& machine) {
  const BuildSpace space = buildSpaceOf(machine);
  const Box3 box = boundingBox(space);
  const std::string description =
      machine.urdf.empty() ? "built in" : "SHA-256 " + sha256Of(readMachineDescription(machine.urdf));
  std::string sheet = "machine: " + space.name + "\ndescription: " + description + '\n';
  for (int i = 0; i < 3; ++i)
    sheet += std::string("reach in ") + "xyz"[i] + ": " + numberText(box.low[i]) + " to " +
             numberText(box.high[i]) + " mm\n";
  return sheet;
}

void requirePrintable(const std::string& path, const MachineSettings& machine) {
  const BuildSpace space = buildSpaceOf(machine);
  const Box3 box = boundingBox(space);
  const Eigen::Affine3d bed_from_program = space.program_from_bed.inverse();
  const bool is_bounded = !space.is_endless[0] && !space.is_endless[1] && !space.is_endless[2];
  std::size_t extrusions = 0;
  GcodeHandlers handlers;
  handlers.dwell = [](std::size_t, double) {};
  handlers.other = [](std::size_t, std::string_view) {};
  handlers.motion = [&](const GcodeMotion& motion) {
    if (motion.extrusion_mm <= 0.0 || motion.start == motion.end) return;
    ++extrusions;
    const Point3 tip = bed_from_program * motion.end;
    const std::string fault = is_bounded ? faultByBox(space, box, tip)
                                         : rangeFault(space, space.bed_from_axes.inverse() * tip, kTolerance);
    if (!fault.empty())
      throw Unreachable("line " + std::to_string(motion.line) + " extrudes to " + describePoint(tip) + "; " +
                        fault);
  };
  readGcodeFile(path, {}, handlers);
  if (extrusions == 0)
    throw InvalidProgram(path + ": extrudes nothing; expected a program that prints a part");
}

}  // namespace lamina
