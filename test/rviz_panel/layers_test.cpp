// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Uses the panel of layers in a real window, as a person would.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QtTest/QTest>

#include "conversions.hpp"
#include "layers/layers_content.hpp"
#include "marker_display.hpp"
#include "names.hpp"
#include "window.hpp"

namespace {

using lamina::LayersContent;
using lamina::test::MarkerDisplay;
using lamina::test::part;
using lamina::test::waitFor;

constexpr int kLayers = 6;

/// One bead of 10 mm in each layer.
lamina::MachineToolpath stack() {
  lamina::MachineToolpath placed;
  placed.id = "0123456789abcdef";
  placed.toolpath.part_name = "stack";
  for (int layer = 1; layer <= kLayers; ++layer) {
    lamina::Path path;
    path.points = {{0, 0, 0.2 * layer}, {10, 0, 0.2 * layer}};
    path.bead = lamina::Bead{0.4, 0.2};
    path.feed_mm_s = 20.0;
    placed.toolpath.layers.push_back({0.2 * layer, 0.2, {path}});
    if (layer == 1) continue;
    lamina::Path travel;
    travel.role = lamina::PathRole::Travel;
    travel.points = {{10, 0, 0.2 * (layer - 1)}, {0, 0, 0.2 * layer}};
    travel.feed_mm_s = 20.0;
    std::vector<lamina::Path>& paths = placed.toolpath.layers.back().paths;
    paths.insert(paths.begin(), travel);
  }
  return placed;
}

class Layers : public testing::Test {
 protected:
  void SetUp() override {
    publisher_ = node_.advertise<lamina_msgs::Toolpath>(lamina::names::kToolpath, 1, true);
    publisher_.publish(toMessage(stack()));
    content_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&content_));
    ASSERT_TRUE(waitFor([&] { return display_.segments("infill") == kLayers; }))
        << part<QLabel>(content_, "part").text().toStdString();
  }

  ros::NodeHandle node_;
  ros::Publisher publisher_;
  MarkerDisplay display_{lamina::names::kShownLayers};
  LayersContent content_{nullptr};
};

TEST_F(Layers, AreShownUpToTheSlider) {
  EXPECT_EQ(part<QLabel>(content_, "part").text().toStdString(), "stack");
  auto& slider = part<QSlider>(content_, "layers");
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Home);
  QTest::keyClick(&slider, Qt::Key_Right);
  EXPECT_EQ(part<QLabel>(content_, "shown_layers").text().toStdString(), "2 of 6");
  EXPECT_TRUE(waitFor([&] { return display_.segments("infill") == 2; }));
}

TEST_F(Layers, HaveTheNozzlesFramesIfAskedFor) {
  EXPECT_EQ(display_.segments("nozzle_z"), 0U);
  part<QDoubleSpinBox>(content_, "frames_every").setValue(4.0);
  // At the start and at the end of each bead.
  EXPECT_TRUE(waitFor([&] { return display_.segments("nozzle_z") == std::size_t{2} * kLayers; }));
  auto& slider = part<QSlider>(content_, "layers");
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Home);
  EXPECT_TRUE(waitFor([&] { return display_.segments("nozzle_x") == 2; }));
}

TEST_F(Layers, OfAnUnsoundToolpathAreRefusedInWords) {
  lamina_msgs::Toolpath broken = toMessage(stack());
  broken.layers.front().paths.front().role = 77;
  publisher_.publish(broken);
  EXPECT_TRUE(waitFor([&] { return part<QLabel>(content_, "part").text().contains("not shown"); }));
}

}  // namespace
