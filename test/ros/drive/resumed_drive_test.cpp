// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Toolpaths that are begun on a bead, and what the driver says of the place.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "lamina/base/scratch_folder.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "ros/drive/two_beads.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

using lamina_msgs::Status;
using test::DriveCell;
using test::kHeight;
using test::twoBeads;
using test::waitUntil;

constexpr char kSpace[] = "/table";
const double kArea = crossSection({1.0, kHeight});  // mm^2 of a bead

/// @return its path
std::string writeBeads(const ScratchFolder& folder, double height_mm) {
  std::string path = folder.path() + "/beads.csv";
  std::ofstream file(path);
  writeCsv(twoBeads(height_mm), [&file](std::string_view piece) { file << piece; });
  return path;
}

/// What the driver says of a file of two beads, of which 13 mm were reported.
lamina_msgs::ResumePlace::Response placeOn(double height_mm) {
  const ScratchFolder folder;
  lamina_msgs::ResumePlace call;
  call.request.program = writeBeads(folder, height_mm);
  call.request.placement = "as_is";
  call.request.laid_length = 0.013;
  // A machine that still settles is asked again.
  EXPECT_TRUE(waitUntil([&call] {
    return callService(std::string(kSpace) + '/' + names::kResumePlace, call) &&
           call.response.status.message.find("still moves") == std::string::npos;
  }));
  return call.response;
}

TEST(ResumedDrive, BeginsAtTheWaypointThatIsNamedAndReportsWhatItLays) {
  lamina_msgs::PrintProgress printed;
  const boost::function<void(const lamina_msgs::PrintProgressConstPtr&)> on_printed =
      [&printed](const auto& message) { printed = *message; };
  ros::NodeHandle node(kSpace);
  const ros::Subscriber subscriber =
      node.subscribe<lamina_msgs::PrintProgress>(names::kPrintProgress, 100, on_printed);
  DriveCell cell("table", "five_axis_head_table");
  cell.from_waypoint = {0, 2, 0};  // of the second bead
  cell.drive(twoBeads());
  ASSERT_TRUE(cell.ends());
  ASSERT_EQ(cell.result().status.code, Status::OK + 0) << cell.result().status.message;
  ASSERT_TRUE(cell.comesTo("Complete")) << cell.state;
  std::size_t deposited = 0;
  for (const DriveCell::Report& report : cell.reports) {
    if (report.process.flow == 0.0) continue;
    ++deposited;
    EXPECT_GT(cell.tip(report).y(), 30.0) << "of the first bead, which is left out";
  }
  EXPECT_GT(deposited, 15U);
  // Both beads of 40 mm count as laid, and the material of the second one as used.
  EXPECT_TRUE(waitUntil([&] { return std::abs(printed.laid_length - 0.080) < 1e-6; })) << printed.laid_length;
  EXPECT_NEAR(printed.laid_volume, 40e-9 * kArea, 0.4e-9 * kArea);
  // It stands at the end of the last bead.
  const auto here = placeOn(kHeight);
  EXPECT_EQ(here.status.message, "");
  EXPECT_TRUE(here.is_found);
  EXPECT_NEAR(here.begin_length, 0.080, 1e-6);
  EXPECT_EQ(here.text, "all 80 mm of its beads are laid");
  // On another height it does not: 2 mm before the least that was laid, as the tip may trail by
  // tracking.tip_mm.
  const auto elsewhere = placeOn(kHeight + 10.0);
  EXPECT_EQ(elsewhere.status.message, "");
  EXPECT_FALSE(elsewhere.is_found);
  EXPECT_NEAR(elsewhere.begin_length, 0.013 - 0.005 - 0.002, 1e-9);
  EXPECT_EQ(elsewhere.waypoint, 1U);
}

/// Somebody has moved the robot, or resume.overlap_mm is another, since a person has looked.
TEST(ResumedDrive, RefusesAPlaceOtherThanTheOneThatWasConfirmed) {
  const ScratchFolder folder;
  DriveCell cell("table", "five_axis_head_table");
  lamina_msgs::DriveToolpathGoal goal;
  goal.program = writeBeads(folder, kHeight + 10.0);
  goal.placement = "as_is";
  goal.resume = 1U;
  goal.laid_length = 0.013;  // begins 7 mm before, as above
  goal.confirmed_length = {0.008};
  // A machine that still settles is asked again.
  EXPECT_TRUE(waitUntil([&] {
    cell.ask(goal);
    return cell.ends() && cell.result().status.message.find("still moves") == std::string::npos;
  }));
  EXPECT_EQ(cell.result().status.code, Status::INVALID_INPUT + 0);
  EXPECT_NE(cell.result().status.message.find(
                "would begin after 6 mm of its beads, and a person has confirmed 8 mm"),
            std::string::npos)
      << cell.result().status.message;
  goal.resume = 0U;
  cell.ask(goal);
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.message,
            "confirmed_length has 1 numbers; expected one at most, with resume");
}

TEST(ResumedDrive, RefusesWaypointsThatTheToolpathDoesNotHave) {
  DriveCell cell("table", "five_axis_head_table");
  cell.from_waypoint = {0, 2};
  cell.drive(twoBeads());
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::INVALID_INPUT + 0);
  EXPECT_EQ(cell.result().status.message, "from_waypoint has 2 numbers; expected layer, path and waypoint");
  cell.from_waypoint = {0, 9, 0};
  cell.drive(twoBeads());
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::INVALID_INPUT + 0) << cell.result().status.message;
}

}  // namespace
}  // namespace lamina
