// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Asks the running node slicing_service for inclined layers.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <filesystem>

#include "conversions.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "request_settings.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

lamina_msgs::SliceMesh::Response slice(const std::vector<std::pair<std::string, std::string>>& settings,
                                       const std::string& output = "") {
  lamina_msgs::SliceMesh service;
  service.request.part = "box";  // a cube of 20 mm
  service.request.output = output;
  for (const auto& [key, value] : settings) service.request.settings.push_back(settingMessage(key, value));
  EXPECT_TRUE(ros::service::waitForService(names::kSliceMesh, ros::Duration(test::kPatience)));
  EXPECT_TRUE(callService(names::kSliceMesh, service));
  return service.response;
}

const std::vector<std::pair<std::string, std::string>> kInclined = {{"slicing.plane.angle_deg", "45"},
                                                                    {"slicing.layer_height_mm", "0.4"},
                                                                    {"slicing.first_layer_height_mm", "0.4"}};

TEST(InclinedSlicing, LayersAndNozzleArriveInclined) {
  const auto response = slice(kInclined);
  ASSERT_EQ(response.status.code, lamina_msgs::Status::OK + 0) << response.status.message;
  ros::NodeHandle node;
  const auto message = ros::topic::waitForMessage<lamina_msgs::Toolpath>(names::kToolpath, node,
                                                                         ros::Duration(test::kPatience));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->id, response.toolpath_id);
  EXPECT_EQ(message->machine, "gantry_45");
  const Eigen::Quaterniond part_from_layers = fromMessage(message->part_from_layers);
  const Eigen::Quaterniond about_x(Eigen::AngleAxisd(M_PI / 4.0, Point3::UnitX()));
  EXPECT_LT(part_from_layers.angularDistance(about_x), 1e-9);
  // The cube is 20 sqrt 2 high along the normal; a layer is where its middle is within.
  EXPECT_EQ(message->layers.size(), static_cast<std::size_t>(std::round(20.0 * M_SQRT2 / 0.4)));
  EXPECT_EQ(response.summary.layers, message->layers.size());
  const Point3 normal(0.0, -M_SQRT1_2, M_SQRT1_2);
  for (const auto& layer : message->layers)
    for (const auto& path : layer.paths) {
      for (const auto& orientation : path.orientation)
        ASSERT_LT((fromMessage(orientation) * Point3::UnitZ() + normal).norm(), 1e-9);
      if (path.role == static_cast<std::uint8_t>(PathRole::Travel)) continue;
      for (const auto& point : path.points)
        ASSERT_NEAR(normal.dot(fromMessage(point)), toMillimetres(layer.z), 1e-6);
    }
}

TEST(InclinedSlicing, ATooSteepOrForeignPlaneIsRefused) {
  const test::ScratchFolder folder;
  const auto steep = slice({{"slicing.plane.angle_deg", "30"}}, folder.file("a.gcode"));
  EXPECT_EQ(steep.status.code, lamina_msgs::Status::UNREACHABLE + 0);
  EXPECT_NE(steep.status.message.find("for slicing.plane.angle_deg 45"), std::string::npos)
      << steep.status.message;
  const auto reverse = slice({{"slicing.plane.angle_deg", "45"}, {"slicing.plane.axis_heading_deg", "180"}},
                             folder.file("a.gcode"));
  EXPECT_EQ(reverse.status.code, lamina_msgs::Status::UNREACHABLE + 0);
  const auto upright = slice({{"slicing.plane.angle_deg", "45"}, {"machine.name", "cartesian_gantry"}});
  EXPECT_EQ(upright.status.code, lamina_msgs::Status::UNREACHABLE + 0);
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.gcode")));
}

TEST(InclinedSlicing, TheMachineMayBeThatOfAFile) {
  auto settings = kInclined;
  settings.emplace_back("machine.urdf",
                        std::string(LAMINA_SOURCE_DIR) + "/urdf/large_gantry_45_reverse.urdf");
  EXPECT_EQ(slice(settings).status.code, lamina_msgs::Status::UNREACHABLE + 0);
  settings.emplace_back("slicing.plane.axis_heading_deg", "180");
  const auto response = slice(settings);
  EXPECT_EQ(response.status.code, lamina_msgs::Status::OK + 0) << response.status.message;
  ros::NodeHandle node;
  const auto message = ros::topic::waitForMessage<lamina_msgs::Toolpath>(names::kToolpath, node,
                                                                         ros::Duration(test::kPatience));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->machine, "large_gantry_45_reverse");
}

}  // namespace
}  // namespace lamina
