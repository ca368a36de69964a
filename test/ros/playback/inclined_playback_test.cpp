// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Inclined programs played on machines whose heads are made for them: every waypoint's tip and tool axis are
// computed anew from tf alone, live and from a recording, and compared with the numbers in the program.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/job/incline_settings.hpp"
#include "messages.hpp"
#include "ros/bag_player.hpp"
#include "ros/playback/tf_recording.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using test::kSameTip;
using test::kSameToolAxis;
using test::TfRecording;

/// A machine, and the inclined program that it plays.
struct Case {
  std::string machine;
  double angle_deg = 45.0;  ///< about x
  Point3 tool_axis = Point3::Zero();
  std::vector<Point3> tips;  ///< of the program [mm, bed frame]
};

/// A square of 20 mm on three layers, tilted against the angle so that it comes out upright.
std::string tiltedSquares(double angle_deg) {
  const double s = std::sin(angle_deg * M_PI / 180.0);
  std::string text = "M83\n;Layer height: 0.5\n";
  for (int layer = 0; layer < 3; ++layer) {
    char line[256];
    const double z = 100.0 + 0.5 * layer;
    std::snprintf(line, sizeof line,
                  ";LAYER:%d\nG0 X0 Y%.3f Z%.3f F6000\nG1 X20 E1 F3000\nG1 Y%.3f E1\nG1 X0 E1\nG1 Y%.3f E1\n",
                  layer, s * layer, z, s * layer + 20.0, s * layer);
    text += line;
  }
  return text + "; end of the part\n";
}

/// Places over the bed of the part's motions, as the text has them.
/// @param is_belt  the text holds axis values of a belt at 45 deg
std::vector<Point3> tipsIn(const std::string& program, bool is_belt) {
  std::vector<Point3> tips;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    if (std::sscanf(line.c_str(), "G%*d X%lf Y%lf Z%lf", &x, &y, &z) != 3) continue;
    // y up the gantry and z the belt: z = y sin a over the belt, y = z cot a - belt along it.
    tips.push_back(is_belt ? Point3(x, y * M_SQRT1_2 - z, y * M_SQRT1_2) : Point3(x, y, z));
  }
  return tips;
}

/// Expects all tips in their order, each with the tool axis.
void expectPlayed(const Case& played, const TfRecording& recording) {
  std::size_t reached = 0;
  for (const Eigen::Isometry3d& nozzle : recording.nozzles()) {
    if (reached == played.tips.size()) break;
    if ((nozzle.translation() - played.tips[reached]).norm() > kSameTip) continue;
    ++reached;
    const Point3 tool_axis = nozzle.linear().col(2);
    const double turn = std::atan2(tool_axis.cross(played.tool_axis).norm(), tool_axis.dot(played.tool_axis));
    EXPECT_LT(turn, kSameToolAxis) << played.machine << ", waypoint " << reached;
  }
  ASSERT_EQ(reached, played.tips.size())
      << played.machine << " never was at " << played.tips[reached].transpose();
}

/// Writes the inclined program, and reports what is to be seen of it.
Case prepare(const std::string& machine, double angle_deg, const std::string& folder) {
  Case made{machine, angle_deg, Point3(0.0, angle_deg > 0.0 ? 1.0 : -1.0, -1.0).normalized(), {}};
  writeFile(folder + "/level.gcode", tiltedSquares(angle_deg));
  const CartesianMachine description = machineByName(machine);
  const bool is_belt = isEndless(description.axes[2]);
  const Box3 room = machineRoom(buildSpaceOf(description));
  const Point2 middle = is_belt ? Point2(room.centre().x(), -100.0) : Point2(room.centre().head<2>());
  std::ostringstream place;
  place << middle.x() << "," << middle.y();
  const InclineSettings settings = loadInclineSettings("", {{"machine.name", machine},
                                                            {"incline.angle_deg", std::to_string(angle_deg)},
                                                            {"incline.table_position_mm", place.str()}});
  NoProgress nobody;
  const std::string output = folder + "/" + machine + ".gcode";
  const RewriteReport report = runInclineJob(inclineJob(settings, folder + "/level.gcode", output), nobody);
  EXPECT_FALSE(isToolAxisOffNormal(report)) << machine;
  made.tips = tipsIn(readFile(output), is_belt);
  EXPECT_EQ(made.tips.size(), 15U) << machine;
  return made;
}

lamina_msgs::LoadProgram::Response load(const std::string& machine, const std::string& program) {
  lamina_msgs::LoadProgram service;
  service.request.program = program;
  const std::string name = "/" + machine + "/trajectory_publisher/load_program";
  EXPECT_TRUE(ros::service::waitForService(name, ros::Duration(test::kPatience)));
  EXPECT_TRUE(callService(name, service));
  return service.response;
}

TEST(InclinedPlayback, TfReportsEveryWaypointLiveAndFromARecording) {
  const test::ScratchFolder folder;
  rosbag::Bag bag(folder.file("played.bag"), rosbag::bagmode::Write);
  std::vector<Case> cases;
  for (const auto& [machine, angle_deg] : {std::pair{"gantry_45", 45.0},
                                           {"large_gantry_45", 45.0},
                                           {"large_gantry_45_reverse", -45.0},
                                           {"belt_45", 45.0}}) {
    cases.push_back(prepare(machine, angle_deg, folder.file("")));
    TfRecording live(machine);
    ASSERT_TRUE(test::waitUntil([&] { return live.isConnected(); }));
    const auto response = load(machine, folder.file(std::string(machine) + ".gcode"));
    ASSERT_EQ(response.status.code, lamina_msgs::Status::OK + 0) << response.status.message;
    EXPECT_EQ(response.toolpath_id.size(), 16U);
    EXPECT_TRUE(test::waitUntil([&] { return live.isAt(cases.back().tips.back()); })) << machine;
    expectPlayed(cases.back(), live);
    live.write(bag);
  }
  bag.close();

  std::vector<std::unique_ptr<TfRecording>> replayed;
  for (const Case& played : cases)
    replayed.push_back(std::make_unique<TfRecording>("replayed/" + played.machine));
  const test::BagPlayer player(folder.file("played.bag"), {"--delay=1", "--rate=4", "--prefix=/replayed"});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_TRUE(test::waitUntil([&] { return replayed[i]->isAt(cases[i].tips.back()); }));
    expectPlayed(cases[i], *replayed[i]);
  }
}

TEST(InclinedPlayback, AMachineFromAFileIsTheOneRvizShows) {
  std::string description;
  ASSERT_TRUE(ros::param::get("/large_gantry_45/robot_description", description));
  EXPECT_EQ(description, readFile(std::string(LAMINA_SOURCE_DIR) + "/urdf/large_gantry_45.urdf"));
}

TEST(InclinedPlayback, ProgramsForAnotherHeadAreRefused) {
  const test::ScratchFolder folder;
  prepare("large_gantry_45", 45.0, folder.file(""));
  const auto other = load("large_gantry_45_reverse", folder.file("large_gantry_45.gcode"));
  EXPECT_EQ(other.status.code, lamina_msgs::Status::UNREACHABLE + 0) << other.status.message;
  EXPECT_EQ(other.toolpath_id, "");
  const auto level = load("gantry_45", folder.file("level.gcode"));
  EXPECT_EQ(level.status.code, lamina_msgs::Status::UNREACHABLE + 0) << level.status.message;
  const auto none = load("gantry_45", folder.file("none.gcode"));
  EXPECT_EQ(none.status.code, lamina_msgs::Status::FILE_ERROR + 0) << none.status.message;
}

TEST(InclinedPlayback, ANodeThatCannotLoadItsProgramEndsWithCode1) {
  const std::string command =
      std::string(LAMINA_PUBLISHER_NODE) +
      " __name:=refused _machine/name:=gantry_45 _load_program:=/nowhere/a.gcode > /dev/null 2>&1";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

}  // namespace
}  // namespace lamina
