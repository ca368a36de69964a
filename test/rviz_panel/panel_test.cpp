// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Uses the panel in a real window, as a person would, with the node behind it.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/config.h>
#include <rviz/panel.h>
#include <pluginlib/class_loader.hpp>

#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QtTest/QTest>
#include <fstream>
#include <map>

#include "incline/panel_content.hpp"
#include "lamina/base/atomic_file.hpp"
#include "marker_display.hpp"
#include "support/scratch_folder.hpp"
#include "window.hpp"

namespace {

using lamina::PanelContent;
using Display = lamina::test::MarkerDisplay;
using lamina::test::part;
using lamina::test::waitFor;

constexpr int kWallLayers = 8;
const char* const kGrey = "#9a9a9a";
const char* const kAmber = "#f0a000";
const char* const kGreen = "#2e9e3f";
const char* const kRed = "#cc2222";

/// A wall 10 mm long of layers 0.5 mm high, tilted by -45 deg about x: upright once it is inclined.
std::string tiltedWall(int layers) {
  std::string text = "M83\n;Layer height: 0.5\n";
  for (int layer = 0; layer < layers; ++layer)
    text += ";LAYER:" + std::to_string(layer) + "\nG0 X5 Y" + std::to_string(100.0 + 0.5 * layer) + " Z" +
            std::to_string(0.5 * layer + 0.5) + " F3000\nG1 X15 E1 F900\n";
  return text + "; end of the part\n";
}

class Panel : public testing::Test {
 protected:
  void open(const std::string& action) {
    content_ = std::make_unique<PanelContent>(nullptr, action);
    content_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(content_.get()));
  }
  void SetUp() override { open("incline_gcode"); }

  void typeSource(const std::string& path) {
    auto& field = part<QLineEdit>(*content_, "source");
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, QString::fromStdString(path));
    QTest::keyClick(&field, Qt::Key_Return);
  }
  void press(const char* button) { QTest::mouseClick(&part<QPushButton>(*content_, button), Qt::LeftButton); }
  bool shines(const char* colour) { return part<QLabel>(*content_, "light").styleSheet().contains(colour); }
  std::string message() { return part<QLabel>(*content_, "message").text().toStdString(); }
  double elapsed() { return part<QLabel>(*content_, "elapsed").text().split(' ').first().toDouble(); }

  lamina::test::ScratchFolder folder_;
  std::unique_ptr<PanelContent> content_;
};

TEST_F(Panel, InclinesTheProgramThatIsChosenAndShowsBothParts) {
  Display original("source_layers");
  auto inclined = std::make_unique<Display>("inclined_layers");
  std::ofstream(folder_.file("wall.gcode")) << tiltedWall(kWallLayers);
  EXPECT_TRUE(shines(kGrey));
  typeSource(folder_.file("wall.gcode"));
  ASSERT_TRUE(waitFor([&] { return original.segments() == kWallLayers; })) << original.segments();
  EXPECT_EQ(inclined->segments(), 0U);
  press("run");
  EXPECT_TRUE(shines(kAmber));
  EXPECT_FALSE(part<QPushButton>(*content_, "run").isEnabled());
  ASSERT_TRUE(waitFor([&] { return !shines(kAmber); }));
  EXPECT_TRUE(shines(kGreen)) << message();
  EXPECT_NE(message().find("8 layers"), std::string::npos) << message();
  // (100 - 0.5) / sqrt(2) is y of the upright wall.
  EXPECT_NE(lamina::readFile(folder_.file("wall_rotate.gcode")).find("Y70.357"), std::string::npos);
  ASSERT_TRUE(waitFor([&] { return inclined->segments() == kWallLayers; })) << inclined->segments();
  EXPECT_EQ(original.segments(), kWallLayers + 0U);

  auto& slider = part<QSlider>(*content_, "layers");
  EXPECT_EQ(slider.maximum(), kWallLayers);
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Home);
  QTest::keyClick(&slider, Qt::Key_Right);
  EXPECT_EQ(part<QLabel>(*content_, "shown_layers").text().toStdString(), "2 of 8");
  EXPECT_TRUE(waitFor([&] { return inclined->segments() == 2 && original.segments() == 2; }));
  inclined.reset();
  inclined = std::make_unique<Display>("inclined_layers");
  EXPECT_TRUE(waitFor([&] { return inclined->segments() == 2; })) << "a newcomer sees what the others see";
}

TEST_F(Panel, DrawsTheSourceAnewIfItWasWrittenAnewBeforeTheRun) {
  Display original("source_layers");
  std::ofstream(folder_.file("wall.gcode")) << tiltedWall(8);
  typeSource(folder_.file("wall.gcode"));
  ASSERT_TRUE(waitFor([&] { return original.segments() == 8; }));
  QTest::qWait(20);
  std::ofstream(folder_.file("wall.gcode")) << tiltedWall(5);
  press("run");
  EXPECT_TRUE(waitFor([&] { return original.segments() == 5; })) << original.segments();
  EXPECT_TRUE(waitFor([&] { return shines(kGreen); }));
}

TEST_F(Panel, ReportsInRedWhatTheNodeRefuses) {
  typeSource(folder_.file("absent.gcode"));
  press("run");
  ASSERT_TRUE(waitFor([&] { return shines(kRed); })) << message();
  EXPECT_NE(message().find("absent.gcode"), std::string::npos) << message();
  EXPECT_EQ(folder_.fileCount(), 0U);
}

TEST_F(Panel, ReportsInRedWhatIsMissingInTheForm) {
  press("run");
  EXPECT_TRUE(shines(kRed));
  EXPECT_NE(message().find("no program"), std::string::npos) << message();
}

TEST_F(Panel, ReportsThatNoNodeIsThere) {
  open("nobody_inclines");
  typeSource("part.gcode");
  press("run");
  EXPECT_TRUE(shines(kAmber));
  ASSERT_TRUE(waitFor([&] { return !shines(kAmber); }));
  EXPECT_TRUE(shines(kRed));
  EXPECT_NE(message().find("no node offers the action nobody_inclines"), std::string::npos) << message();
}

TEST_F(Panel, CancelsARunAndCountsItsTime) {
  open("slow_incline");
  typeSource("part.gcode");
  press("run");
  ASSERT_TRUE(waitFor([&] { return part<QProgressBar>(*content_, "progress").value() == 250; }));
  EXPECT_TRUE(part<QProgressBar>(*content_, "progress").format().startsWith("write"));
  ASSERT_TRUE(waitFor([&] { return elapsed() >= 0.5; }));
  press("cancel");
  ASSERT_TRUE(waitFor([&] { return !shines(kAmber); }));
  EXPECT_TRUE(shines(kGrey));
  EXPECT_NE(message().find("cancelled"), std::string::npos) << message();
  const double stopped = elapsed();
  QTest::qWait(300);
  EXPECT_DOUBLE_EQ(elapsed(), stopped);
  EXPECT_TRUE(part<QPushButton>(*content_, "run").isEnabled());
}

TEST_F(Panel, ReportsThatANodeGivesNoResult) {
  open("slow_incline");
  typeSource("odd.gcode");
  press("run");
  ASSERT_TRUE(waitFor([&] { return shines(kRed); }));
  EXPECT_NE(message().find("no result"), std::string::npos) << message();
}

TEST_F(Panel, CanBeClosedDuringARun) {
  open("slow_incline");
  typeSource("part.gcode");
  press("run");
  ASSERT_TRUE(waitFor([&] { return part<QProgressBar>(*content_, "progress").value() == 250; }));
  content_.reset();
  open("slow_incline");
  typeSource("part.gcode");
  press("run");
  EXPECT_TRUE(waitFor([&] { return part<QProgressBar>(*content_, "progress").value() == 250; }));
  press("cancel");
  EXPECT_TRUE(waitFor([&] { return shines(kGrey); }));
}

TEST(RvizPanel, IsFoundByRvizAndKeepsItsFormInRvizsConfiguration) {
  pluginlib::ClassLoader<rviz::Panel> loader("rviz", "rviz::Panel");
  rviz::Config config;
  {
    const auto panel = loader.createUniqueInstance("lamina/Incline");
    part<QLineEdit>(*panel, "source").setText("/p/mould.gcode");
    part<QPlainTextEdit>(*panel, "end_code").setPlainText("M104 S0\nM84");
    panel->save(config);
  }
  const auto panel = loader.createUniqueInstance("lamina/Incline");
  panel->load(config);
  EXPECT_EQ(part<QLineEdit>(*panel, "source").text().toStdString(), "/p/mould.gcode");
  EXPECT_EQ(part<QPlainTextEdit>(*panel, "end_code").toPlainText().toStdString(), "M104 S0\nM84");
}

TEST_F(Panel, ReportsWhatIsWrongWithASavedForm) {
  content_->load({{"source", "part.gcode"}, {"angle_deg", "steep"}});
  EXPECT_TRUE(shines(kRed));
  EXPECT_NE(message().find("steep"), std::string::npos) << message();
  EXPECT_EQ(part<QLineEdit>(*content_, "source").text().toStdString(), "");
}

/// Last, for the node is gone afterwards.
TEST_F(Panel, ReportsThatTheNodeDiedAmidTheRun) {
  open("slow_incline");
  typeSource("die.gcode");
  press("run");
  ASSERT_TRUE(waitFor([&] { return shines(kRed); }));
  EXPECT_NE(message().find("is gone"), std::string::npos) << message();
}

}  // namespace
