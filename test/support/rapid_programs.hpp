// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/program/rapid/writer/rapid_writer.hpp"
#include "support/random_toolpath.hpp"

namespace lamina::test {

/// The texts of all modules, main first.
inline std::vector<std::string> rapidModules(const Toolpath& toolpath, const RapidSettings& settings) {
  const RapidProgram program(toolpath, Eigen::Isometry3d::Identity(), settings);
  std::vector<std::string> texts(program.moduleNames().size());
  for (std::size_t m = 0; m < texts.size(); ++m)
    program.write(m, [&](std::string_view piece) { texts[m] += piece; });
  return texts;
}

/// The lines of all procedures of points, in their order.
inline std::vector<std::string> pointLines(const std::vector<std::string>& modules) {
  std::vector<std::string> lines;
  for (const std::string& text : modules) {
    for (std::size_t begin = text.find("  PROC deposit_"); begin != std::string::npos;
         begin = text.find("  PROC deposit_", begin)) {
      begin = text.find('\n', begin) + 1;
      const std::size_t end = text.find("  ENDPROC\n", begin);
      while (begin < end) {
        const std::size_t line_end = text.find('\n', begin);
        lines.push_back(text.substr(begin, line_end - begin));
        begin = line_end + 1;
      }
    }
  }
  return lines;
}

inline std::size_t countOf(const std::vector<std::string>& lines, const std::string& text) {
  std::size_t count = 0;
  for (const std::string& line : lines) count += line.find(text) != std::string::npos ? 1 : 0;
  return count;
}

inline Eigen::Quaterniond randomTilt(Random& random) {
  const Eigen::AngleAxisd about_x(random.uniform(-1.0, 1.0), Point3::UnitX());
  const Eigen::AngleAxisd about_y(random.uniform(-1.0, 1.0), Point3::UnitY());
  return about_x * about_y * nozzleDown();
}

/// The toolpath with a nozzle that turns from waypoint to waypoint; some paths start in another pose than
/// that in which the one before ends.
inline Toolpath tilted(Toolpath toolpath, std::uint64_t seed) {
  Random random(seed);
  Eigen::Quaterniond last = nozzleDown();
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      std::vector<Eigen::Quaterniond> each;
      for (std::size_t i = 0; i < path.points.size(); ++i) each.push_back(randomTilt(random));
      if (random.below(3) != 0) each.front() = last;
      last = path.is_closed ? each.front() : each.back();
      path.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
    }
  return toolpath;
}

}  // namespace lamina::test
