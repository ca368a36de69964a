// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What is known of a job that was cut off: how much of it is laid, and where the machine came to rest.
#include <gtest/gtest.h>

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
using test::kHalf;
using test::kHeight;
using test::straight;
using test::twoBeads;
using test::waitUntil;

constexpr char kTable[] = "/table";

/// The way to rest takes 15 mm and more here, as a controller reacts after half a second. The bead lasts 4 s,
/// so that an abort which comes late on a busy host still comes on it.
TEST(ResumedDrive, CountsNothingAsLaidOnceAnAbortHasSwitchedTheProcessOff) {
  lamina_msgs::PrintProgress printed;
  const boost::function<void(const lamina_msgs::PrintProgressConstPtr&)> on_printed =
      [&printed](const auto& message) { printed = *message; };
  ros::NodeHandle node(kTable);
  const ros::Subscriber subscriber =
      node.subscribe<lamina_msgs::PrintProgress>(names::kPrintProgress, 100, on_printed);
  DriveCell cell("table", "five_axis_head_table");
  const double end = 100.0;
  const Point3 from(-kHalf, 0, kHeight);
  cell.drive(
      {"a long bead", {{kHeight, kHeight, {straight(PathRole::OuterWall, from, Point3(end, 0, kHeight))}}}});
  ASSERT_TRUE(waitUntil([&] { return printed.laid_length > 0.004 || cell.isDone(); }));
  ASSERT_TRUE(cell.calls("abort"));
  ASSERT_TRUE(cell.ends());
  ASSERT_TRUE(cell.comesTo("Aborted")) << cell.state;
  ASSERT_TRUE(cell.staysSafe());
  const Point3 last = cell.tip(cell.reports[cell.lastDeposit()]);
  ASSERT_LT(last.x(), end - 15.0) << "too late to be told apart";
  EXPECT_NEAR(1e3 * printed.laid_length, last.x() + kHalf, 3.0);
  const double per_mm = 1e-9 * crossSection({1.0, kHeight});
  EXPECT_NEAR(printed.laid_volume, per_mm * (last.x() + kHalf), 3.0 * per_mm);
}

/// The next job is aborted on the way to its start, slowly and far above.
TEST(ResumedDrive, KnowsWhereItCameToRestAfterAnApproachThatWasAborted) {
  DriveCell cell("table", "five_axis_head_table");
  const Point3 from(-kHalf, 5, kHeight);
  const Point3 to(0, 5, kHeight);
  cell.drive({"half a bead", {{kHeight, kHeight, {straight(PathRole::OuterWall, from, to)}}}});
  ASSERT_TRUE(cell.ends());
  ASSERT_EQ(cell.result().status.code, Status::OK + 0) << cell.result().status.message;
  ASSERT_TRUE(cell.staysSafe());
  cell.setSpeed(0.05);
  cell.drive(twoBeads(kHeight + 60.0));
  ASSERT_TRUE(waitUntil([&] { return (cell.tip(cell.reports.back()) - to).norm() > 2.0 || cell.isDone(); }));
  EXPECT_EQ(cell.state, "Starting");
  EXPECT_TRUE(cell.calls("abort"));
  cell.setSpeed(1.0);
  ASSERT_TRUE(cell.ends());
  ASSERT_TRUE(cell.staysSafe());
  ASSERT_GT((cell.tip(cell.reports.back()) - to).norm(), 2.0);
  const ScratchFolder folder;
  lamina_msgs::ResumePlace call;
  call.request.program = folder.path() + "/two.csv";
  call.request.placement = "as_is";
  call.request.laid_length = 0.019;
  {
    std::ofstream file(call.request.program);
    writeCsv(twoBeads(), [&file](std::string_view piece) { file << piece; });
  }
  EXPECT_TRUE(waitUntil([&call] {
    return callService(std::string(kTable) + '/' + names::kResumePlace, call) &&
           call.response.status.message.find("still moves") == std::string::npos;
  }));
  EXPECT_EQ(call.response.status.message, "");
  EXPECT_TRUE(call.response.is_found) << call.response.text;
  EXPECT_NEAR(call.response.begin_length, 0.018, 2e-5) << "the overlap before 20 mm";
}

}  // namespace
}  // namespace lamina
