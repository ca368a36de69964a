// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What RViz is shown, and what is printed.
#include <ros/time.h>

#include "lamina/job/job_settings.hpp"
#include "markers/frame_markers.hpp"
#include "nodes/deposition_simulator/deposit_messages.hpp"
#include "nodes/print_part/print_part_settings.hpp"
#include "ros/settings/node_probes.hpp"
#include "support/toolpaths.hpp"
#include "support/voxel_shapes.hpp"

namespace lamina::test {
namespace {

/// How finely a cube of voxels is shown.
std::string shownCube(const SettingTexts& set) {
  ros::Time::init();
  const VoxelGrid cube = solidBox({30, 30, 30}, 0.1);
  const ShownSettings shown = settingsWith<DepositionSimulatorSettings>(set).shown;
  return numbersText({double(depositedCloud(cube, shown).width),
                      double(depositedMarkers(cube, shown).markers.front().points.size())});
}

/// The nozzle's frames along a toolpath.
std::string shownFrames(const SettingTexts& set) {
  std::vector<double> numbers;
  for (const auto& marker : frameMarkers(twoLayers(), settingsWith<JobSettings>(set).frames, "part").markers)
    for (const auto& point : marker.points) numbers.insert(numbers.end(), {point.x, point.y, point.z});
  return numbersText(numbers);
}

}  // namespace

std::vector<SettingProbe> shownProbes() {
  return {{"a cube that is shown", "", shownCube, {{"shown.points=1000"}, {"shown.triangles=1000"}}},
          {"frames that are shown",
           "frames.every_mm=5",
           shownFrames,
           {{"frames.every_mm=20"}, {"frames.length_mm=3"}}}};
}

}  // namespace lamina::test
