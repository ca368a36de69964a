// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/incline_job.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/program_file.hpp"

namespace lamina {
namespace {

constexpr std::string_view kSuffix = ".gcode";

void requireGcode(const std::string& program) {
  if (!isGcodeFile(program)) requireSuffix(program, {std::string(kSuffix)});
}

}  // namespace

std::string inclinedName(const std::string& program) {
  requireGcode(program);
  return program.substr(0, program.size() - kSuffix.size()) + "_rotate" + std::string(kSuffix);
}

Box3 largeGantryRoom() { return {Point3::Zero(), Point3(1300.0, 2500.0, 1000.0)}; }

Box3 machineRoom(const BuildSpace& space) {
  Box3 room = boundingBox(space);
  room.low.z() = std::max(room.low.z(), 0.0);  // below is the bed, however far the axis goes
  return room;
}

RewriteReport runInclineJob(const InclineJob& job, Progress& progress) {
  if (!job.map) throw InvalidInput("no map of space is given; expected a rotation or another one");
  requireGcode(job.program);
  const std::string output = job.output.empty() ? inclinedName(job.program) : job.output;
  requireSuffix(output, {std::string(kSuffix)});
  requireApart({output}, {job.program});
  return rewriteProgram({job.program, output}, {*job.map, job.axes.get()}, job.settings, progress);
}

}  // namespace lamina
