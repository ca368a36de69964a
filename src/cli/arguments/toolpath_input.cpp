// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/toolpath_input.hpp"

#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "output/terminal_progress.hpp"

namespace lamina::cli {
namespace {

constexpr double kSamePlane = 1e-6;  // rad: digits of a setting

}  // namespace

bool isPart(const std::string& input) { return !isProgramFile(input) && !isToolpathFile(input); }

ToolpathInput readToolpath(const std::string& input, const JobSettings& settings) {
  ToolpathInput read;
  if (isPart(input)) {
    TerminalProgress progress;
    SlicedPart sliced = runSliceJob({input, "", settings}, progress);
    read = {std::move(sliced.toolpath), sliced.bed_from_part};
  } else {
    read.toolpath = readToolpathFile(input, settings.program, settings.machine);
  }
  return read;
}

Toolpath onBed(ToolpathInput input) {
  const bool is_there = input.bed_from_part.matrix() == Eigen::Matrix4d::Identity();
  return is_there ? std::move(input.toolpath) : placed(input.toolpath, input.bed_from_part);
}

ToolpathInput readInclinedToolpath(const std::string& input, const JobSettings& settings) {
  ToolpathInput read = readToolpath(input, settings);
  const PlaneSettings& plane = settings.slicing.plane;
  if (isPart(input) || plane.angle_deg == 0.0) return read;
  const Eigen::Quaterniond asked = partFromLayers(plane);
  if (!isInclined(read.toolpath)) {
    read.toolpath.part_from_layers = asked;
    const bool is_normal = plane.tool_axis == ToolAxis::Normal;
    read.toolpath = withNozzle(std::move(read.toolpath), is_normal ? asked * nozzleDown() : nozzleDown());
  } else if (read.toolpath.part_from_layers.angularDistance(asked) > kSamePlane) {
    throw InvalidInput("slicing.plane.angle_deg is " + numberText(plane.angle_deg) + ", but '" + input +
                       "' states layers inclined by " + numberText(inclinationDeg(read.toolpath)) +
                       " deg another way; expected the same or none");
  }
  return read;
}

}  // namespace lamina::cli
