// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "lamina/base/atomic_file.hpp"
#include "support/rapid_programs.hpp"
#include "support/toolpaths.hpp"

// The lines that are printed in [Flores2018, figures 66 to 71],
// each after its number; between them stand as many points as their numbers ask for.
namespace lamina {
namespace {

std::map<std::size_t, std::string> listing(const std::string& name) {
  std::istringstream text(readFile(std::string(LAMINA_TEST_DATA) + "/" + name));
  std::map<std::size_t, std::string> lines;
  for (std::string line; std::getline(text, line);) {
    const std::size_t space = std::min(line.find(' '), line.size());
    lines[std::stoul(line.substr(0, space))] = line.substr(std::min(space + 1, line.size()));
  }
  return lines;
}

void expectListed(const std::string& name, const Toolpath& toolpath, const RapidSettings& settings) {
  const auto lines = test::pointLines(test::rapidModules(toolpath, settings));
  const auto expected = listing(name);
  ASSERT_EQ(expected.size(), 10U);
  for (const auto& [number, line] : expected) {
    ASSERT_LE(number, lines.size());
    EXPECT_EQ(lines[number - 1], line) << name << " line " << number;
  }
}

/// Runs the points one after the other: a run, a travel, and a run.
Toolpath twoRuns(const std::vector<Point3>& first, const std::vector<Point3>& second) {
  Path run = test::straightPath(first[0], first[1]);
  run.points = first;
  Path travel = test::straightPath(first.back(), second.front());
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  travel.feed_mm_s = 50.0;
  Path next = run;
  next.points = second;
  return {"listing", {{0.4, 0.4, {run, travel, next}}}};
}

/// The printed points of 3 axes: 208 of the first loop, of which three and the last are known.
Toolpath threeAxes() {
  std::vector<Point3> loop = {{59.6502, 36.3864, 0.4}, {60.7964, 35.6326, 0.4}, {61.9177, 34.9028, 0.4}};
  while (loop.size() < 207) loop.push_back(loop.back() + Point3(0.01, 0, 0));
  loop.push_back({59.6266, 36.4023, 0.4});
  return twoRuns(loop, {{5.6250, 43.5913, 0.4}, {4.7500, 46.1282, 0.4}, {4.7500, 47.0, 0.4}});
}

TEST(RapidListings, OfPowderWithThreeAxesAreWrittenByteForByte) {
  RapidSettings settings;
  settings.variant = RapidVariant::Powder3Axes;
  expectListed("rapid_powder_3_axes.txt", threeAxes(), settings);
}

TEST(RapidListings, OfWireWithThreeAxesAreWrittenByteForByte) {
  RapidSettings settings;
  settings.variant = RapidVariant::Wire3Axes;
  settings.wire_stop_s = 0.02;  // 0.6 mm, on the way of the last move as printed
  expectListed("rapid_wire_3_axes.txt", threeAxes(), settings);
}

TEST(RapidListings, OfPowderWithFiveAxesAreWrittenByteForByte) {
  std::vector<Point3> layer = {{59.6502, 36.3864, 0.4}, {60.7964, 35.6326, 0.4}, {61.9177, 34.9028, 0.4}};
  std::vector<Eigen::Quaterniond> tools = {{-0.0343327, 0.0017798, 0.9980680, 0.0517530},
                                           {-0.0340516, 0.0017715, 0.9980681, 0.0519375},
                                           {-0.0338570, 0.0017657, 0.9980681, 0.0520640}};
  while (layer.size() < 308) layer.push_back(layer.back() + Point3(0.01, 0, 0));
  layer.push_back({77.4498, 22.4552, 0.4});
  tools.resize(layer.size(), {0, 0, 1, 0});
  Toolpath toolpath = twoRuns(layer, {{73.4039, 10.7732, 8.4}, {73.7163, 10.8980, 8.4}, {74, 11, 8.4}});
  auto& paths = toolpath.layers[0].paths;
  for (Path& path : paths) path.feed_mm_s = 20.0;
  const std::vector<Eigen::Quaterniond> next = {{0.0180419, 0.0010750, 0.9980662, -0.0594741},
                                                {0.0183113, 0.0010895, 0.9980662, -0.0593924},
                                                {0, 0, 1, 0}};
  paths[0].orientation = AlongPath<Eigen::Quaterniond>(tools);
  paths[1].orientation =
      AlongPath<Eigen::Quaterniond>(std::vector<Eigen::Quaterniond>{tools.back(), next[0]});
  paths[2].orientation = AlongPath<Eigen::Quaterniond>(next);
  RapidSettings settings;
  settings.deposition_speed = settings.air_speed = "v20";
  settings.is_thesis_compatible = true;
  expectListed("rapid_powder_5_axes.txt", toolpath, settings);
}

TEST(RapidListings, HaveSixExternalAxesUnlessTheThesisIsToBeMatched) {
  RapidSettings settings;
  const std::string line = test::pointLines(test::rapidModules(threeAxes(), settings))[0];
  EXPECT_NE(line.find(",[0.000,9e+09,9e+09,9e+09,9e+09,9e+09]],speed_aire,fine,"), std::string::npos) << line;
}

}  // namespace
}  // namespace lamina
