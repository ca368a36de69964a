// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/program_void_job.hpp"

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/output_files.hpp"

namespace lamina {
namespace {

VoidFillingReport fillBeads(const ProgramVoidJob& job, Progress& progress) {
  if (job.part.empty())
    throw InvalidInput("no part is given for '" + job.program +
                       "'; voids between beads are those of a part, which must be named");
  VoidFillingJob filling;
  filling.program = job.program;
  filling.output = job.output;
  filling.map.part = job.part;
  filling.map.settings = job.settings;
  return runVoidFillingJob(filling, progress);
}

DropVoidReport fillDrops(std::string text, const ProgramVoidJob& job, Progress& progress) {
  const DropDialect& dialect = job.settings.program.drops;
  FilledDropProgram filled =
      fillDropProgram(parseDropProgram(std::move(text), dialect), job.settings.drop_voids, dialect, progress);
  if (!job.output.empty()) writeFile(job.output, filled.text);
  return std::move(filled.report);
}

}  // namespace

ProgramVoidReport runProgramVoidJob(const ProgramVoidJob& job, Progress& progress) {
  requireSuffix(job.output, {".gcode"});
  requireApart({job.output}, {job.program, job.part});
  std::string text = readTextFile(job.program);
  if (isDropProgram(text, job.settings.program.drops)) return fillDrops(std::move(text), job, progress);
  return fillBeads(job, progress);
}

}  // namespace lamina
