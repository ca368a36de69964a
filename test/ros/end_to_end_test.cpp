// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints a small part through all nodes and compares what was executed and measured with what was planned.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "conversions.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "nodes/print_part/print_part.hpp"
#include "ros_home.hpp"
#include "wait_until.hpp"

namespace {

namespace fs = std::filesystem;
using lamina::Point3;

const std::string kFolder = lamina::test::inRosHome("end_to_end");
constexpr std::size_t kLayers = 5;            // of 0.3 mm, as in config/demo.yaml
constexpr double kMeanErrorBound = 0.05;      // mm, over all layers: a sixth of a layer
constexpr double kLayerMeanErrorBound = 0.1;  // mm
constexpr double kSamePosition = 1e-6;        // mm: the program's third decimal goes through metres and back

/// Positions the machine reported, in their order [mm].
class PositionRecord {
 public:
  explicit PositionRecord(ros::NodeHandle node) {
    const boost::function<void(const sensor_msgs::JointStateConstPtr&)> onPosition =
        [this](const auto& state) {
          EXPECT_EQ(state->position.size(), 3U);
          positions_.emplace_back(lamina::toMillimetres(state->position.at(0)),
                                  lamina::toMillimetres(state->position.at(1)),
                                  lamina::toMillimetres(state->position.at(2)));
        };
    subscriber_ =
        node.subscribe<sensor_msgs::JointState>(lamina::names::kMachinePosition, 1000000, onPosition);
  }
  const std::vector<Point3>& positions() const { return positions_; }

 private:
  std::vector<Point3> positions_;
  ros::Subscriber subscriber_;
};

std::string writtenBox() {
  std::string path = kFolder + "/box.stl";
  lamina::writeStl(path, lamina::makePart("box", {{"x_mm", "12"}, {"y_mm", "12"}, {"z_mm", "1.5"}}));
  return path;
}

/// Ends of all motions of the program [mm].
std::vector<Point3> motionEnds(const std::string& program) {
  std::vector<Point3> ends;
  lamina::GcodeHandlers handlers;
  handlers.motion = [&](const lamina::GcodeMotion& motion) {
    if ((motion.end - motion.start).norm() > 0.0) ends.push_back(motion.end);
  };
  lamina::readGcodeFile(program, {}, handlers);
  return ends;
}

std::size_t commandLines(const std::string& program) {
  std::ifstream file(program);
  std::size_t commands = 0;
  for (std::string line; std::getline(file, line);) commands += !line.empty() && line[0] != ';';
  return commands;
}

/// The first of `expected` that `actual` does not hold in this order; their number if it holds all.
std::size_t firstMissing(const std::vector<Point3>& expected, const std::vector<Point3>& actual) {
  std::size_t found = 0;
  for (const Point3& position : actual)
    if (found < expected.size() && (position - expected[found]).norm() < kSamePosition) ++found;
  return found;
}

void expectAccounted(const lamina_msgs::ProfileCounts& of) {
  EXPECT_EQ(of.received, of.of_layers + of.of_no_layer + of.waiting + of.without_frame + of.malformed +
                             of.without_transform + of.without_nozzle + of.pushed_out + of.in_gap + of.late);
  EXPECT_EQ(of.points_received, of.points_used + of.points_outside + of.points_not_finite +
                                    of.points_dropped + of.points_waiting);
}

/// Whether the node answers that it has this service, which all nodes have.
bool isAlive(const std::string& name) {
  return ros::service::exists("/" + name + "/set_logger_level", false);
}

lamina::PrintReport print(const ros::NodeHandle& node) {
  lamina::PrintPartSettings settings;
  settings.part = writtenBox();
  settings.output_folder = kFolder;
  return lamina::PrintPart(node, settings).run();
}

TEST(EndToEnd, APartIsSlicedStreamedExecutedAndMeasured) {
  fs::create_directories(kFolder);
  ros::NodeHandle node;
  const PositionRecord record(node);
  const lamina::PrintReport report = print(node);
  const std::string program = kFolder + "/part.gcode";

  EXPECT_EQ(report.slicing.layers, kLayers);
  EXPECT_EQ(report.streaming.lines_acknowledged, commandLines(program));
  const std::vector<Point3> planned = motionEnds(program);
  EXPECT_GT(planned.size(), 10 * kLayers);
  // The report is there before the last lift has been reported.
  lamina::test::waitUntil([&] { return firstMissing(planned, record.positions()) == planned.size(); });
  EXPECT_EQ(firstMissing(planned, record.positions()), planned.size()) << "a motion was not executed";

  ASSERT_EQ(report.layers.size(), kLayers);
  EXPECT_TRUE(report.unreported.empty());
  EXPECT_TRUE(report.has_everything);
  EXPECT_EQ(lamina::unplacedText(report.counts), "");
  EXPECT_EQ(report.counts.waiting, 0U) << "the counts are those of the end";
  expectAccounted(report.counts);
  for (std::size_t i = 0; i < kLayers; ++i) {
    const auto& layer = report.layers[i];
    EXPECT_EQ(layer.layer, i);
    EXPECT_EQ(layer.sight, lamina_msgs::LayerHeight::SEEN + 0) << "layer " << layer.layer;
    EXPECT_EQ(layer.toolpath_id, report.toolpath_id);
    EXPECT_NEAR(lamina::toMillimetres(layer.mean_error), 0.0, kLayerMeanErrorBound)
        << "layer " << layer.layer;
  }
  EXPECT_NEAR(lamina::heightError(report.layers).mean_mm, 0.0, kMeanErrorBound);
  for (const char* file : {"toolpath.png", "height_map.png", "deviation.png", "layer_heights.csv", "summary"})
    EXPECT_GT(fs::file_size(fs::path(kFolder) / file), 100U) << file;
  for (const char* name : {"slicing_service", "trajectory_publisher", "gcode_streamer", "emulated_machine",
                           "layer_height_monitor"})
    EXPECT_TRUE(isAlive(name)) << name;
  fs::remove_all(kFolder);
}

TEST(EndToEnd, ANodeThatIsNotThereIsGivenUpAfterItsTime) {
  lamina::PrintPartSettings settings;
  settings.part = "box";
  settings.output_folder = kFolder;
  settings.patience_s = 0.5;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THROW(lamina::PrintPart(ros::NodeHandle("elsewhere"), settings), lamina::TimedOut);
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(waited.count(), 0.5);
  EXPECT_LT(waited.count(), 60.0) << "half the usual time";
  fs::remove_all(kFolder);
}

TEST(EndToEnd, TheSamePartPrintedAgainIsMeasuredAfresh) {
  fs::create_directories(kFolder);
  const ros::NodeHandle node;
  const lamina::PrintReport first = print(node);
  const lamina::PrintReport second = print(node);
  EXPECT_EQ(second.toolpath_id, first.toolpath_id);
  EXPECT_TRUE(second.has_everything);
  ASSERT_EQ(second.layers.size(), kLayers);
  for (std::size_t i = 0; i < kLayers; ++i) {
    EXPECT_EQ(second.layers[i].layer, i);
    EXPECT_EQ(second.layers[i].sight, lamina_msgs::LayerHeight::SEEN + 0) << "layer " << i;
  }
  EXPECT_EQ(second.counts.received, first.counts.received) << "both scan a printed part";
  expectAccounted(second.counts);
  fs::remove_all(kFolder);
}

}  // namespace
