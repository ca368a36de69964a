// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/tool_offsets.hpp"

#include <cmath>
#include <cstdio>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::string_view kToolOffsetMark = "TOOL_OFFSET:";
constexpr unsigned kMostToolsRead = 64;

}  // namespace

Point3 toolOffset(std::uint32_t tool, const ProgramSettings& settings, const ProgramFrame& frame) {
  if (tool >= settings.tool_offsets_mm.size()) return Point3::Zero();
  return frame.program_from_bed.linear() * settings.tool_offsets_mm[tool];
}

std::string toolOffsetComments(const ProgramSettings& settings, const ProgramFrame& frame) {
  std::string comments;
  for (std::uint32_t tool = 0; tool < settings.tool_offsets_mm.size(); ++tool) {
    const Point3 offset = toolOffset(tool, settings, frame);
    if (offset.isZero(0.0)) continue;
    char line[128];
    std::snprintf(line, sizeof line, ";TOOL_OFFSET:%u %.17g %.17g %.17g\n", static_cast<unsigned>(tool),
                  offset.x(), offset.y(), offset.z());
    comments += line;
  }
  return comments;
}

void readToolOffset(std::string_view comment, std::vector<Point3>& offsets_mm) {
  if (comment.substr(0, kToolOffsetMark.size()) != kToolOffsetMark) return;
  const std::string text(comment.substr(kToolOffsetMark.size()));
  unsigned tool = 0;
  Point3 offset;
  const int count = std::sscanf(text.c_str(), "%u %lf %lf %lf", &tool, &offset.x(), &offset.y(), &offset.z());
  if (count != 4 || tool >= kMostToolsRead || !offset.allFinite())
    throw InvalidProgram("the comment ';" + std::string(comment) +
                         "' states no offset; expected the number of a tool and three lengths");
  if (offsets_mm.size() <= tool) offsets_mm.resize(tool + 1, Point3::Zero());
  offsets_mm[tool] = offset;
}

}  // namespace lamina
