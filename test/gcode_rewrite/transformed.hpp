// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/gcode_rewrite/gcode_rewrite.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/program/program_frame.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {

/// A program after a transform.
struct Transformed {
  std::string text;  ///< without the comments that report the frame
  StatedFrame frame;
  RewriteReport report;
};

/// Takes the comments that report the frame out of a program.
inline StatedFrame takeFrame(std::string& program) {
  StatedFrame frame;
  std::string rest;
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find('\n', begin), program.size() - 1) + 1;
    const std::string line = program.substr(begin, end - begin);
    if (line[0] != ';' || !readFrameComment(line.substr(1), frame)) rest += line;
    begin = end;
  }
  program = rest;
  return frame;
}

inline AffineMap aboutX45() { return rotation(Point3::UnitX(), 45.0); }

inline Transformed transformed(const std::string& program, const RewriteSettings& settings,
                               const SpaceMap& map = aboutX45(), const SpaceMap* axes = nullptr) {
  const ScratchFolder folder;
  writeFile(folder.file("in.gcode"), program);
  NoProgress progress;
  Transformed result;
  result.report =
      rewriteProgram({folder.file("in.gcode"), folder.file("out.gcode")}, {map, axes}, settings, progress);
  result.text = readFile(folder.file("out.gcode"));
  result.frame = takeFrame(result.text);
  return result;
}

inline RewriteSettings withHeight(double layer_height_mm) {
  RewriteSettings settings;
  settings.layer_height_mm = layer_height_mm;
  return settings;
}

inline RewriteSettings asSliced() {
  RewriteSettings settings;
  settings.lift = Lift::None;
  return settings;
}

/// The motions of a program as any other reader takes them.
inline std::vector<GcodeMotion> motionsOf(const std::string& program) {
  std::vector<GcodeMotion> motions;
  GcodeHandlers handlers;
  handlers.motion = [&](const GcodeMotion& motion) { motions.push_back(motion); };
  GcodeReader reader({}, handlers);
  reader.read(program);
  reader.finish();
  return motions;
}

inline bool contains(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

/// The program of [Garcia2024, figure 3.4]: a cube of 350 mm on an edge, with relative E.
inline std::string publishedExample() {
  return "M83\n;LAYER:0\nM107\nG1 F1200 Z4.5\nG0 F18000 X474.333 Y302.047 Z4.5\n;MESH:Cubo.stl\n"
         ";TYPE:WALL-OUTER\nG1 F1200 Z1.5\nG1 F3600 E13.05577\nG1 F884.2 X475.099 Y302.126 E0.45598\n"
         "G1 F884.3 X650.239 Y302.125 E103.69276\nG1 X825.379 Y302.124 E103.69276\n";
}

}  // namespace lamina::test
