// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/drawn_part.hpp"

#include <filesystem>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"

namespace lamina {
namespace {

void requireDrawable(const std::string& path) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (!error && bytes > kLargestDrawn)
    throw InvalidInput("'" + path + "' has " + std::to_string(bytes >> 20U) + " MiB; up to " +
                       std::to_string(kLargestDrawn >> 20U) + " are drawn");
}

Toolpath read(const std::string& path, const std::atomic<bool>& is_cancelled) {
  ToolpathBuilder builder{ProgramSettings()};
  GcodeHandlers handlers;
  handlers.motion = [&](const GcodeMotion& motion) {
    if (is_cancelled) throw Cancelled("another program is drawn");
    builder.add(motion);
  };
  handlers.comment = [&](std::string_view comment) { builder.readComment(comment); };
  readGcodeFile(path, {}, handlers);
  Toolpath toolpath = builder.finish(path);
  if (toolpath.layers.empty()) throw InvalidProgram("'" + path + "' has nothing to draw");
  return toolpath;
}

std::vector<PathRole> rolesIn(const Toolpath& toolpath) {
  std::set<PathRole> roles;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) roles.insert(path.role);
  return {roles.begin(), roles.end()};
}

}  // namespace

DrawnPart drawProgram(const std::string& path, const std::string& frame,
                      const std::atomic<bool>& is_cancelled) {
  DrawnPart part;
  try {
    requireDrawable(path);
    const Toolpath toolpath = read(path, is_cancelled);
    part.layers = toolpath.layers.size();
    part.box = depositionBox(toolpath);
    part.roles = rolesIn(toolpath);
    part.chunks = toolpathMarkerChunks(toolpath, frame);
  } catch (...) {
    part.failure = currentFailure().message;
  }
  return part;
}

}  // namespace lamina
