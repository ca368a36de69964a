// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Slices and prints in a real window, as a person would, with slicing service, streamer and an emulated
// machine.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/config.h>
#include <rviz/panel.h>
#include <pluginlib/class_loader.hpp>

#include <QApplication>
#include <QCheckBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QUrl>
#include <QtTest/QTest>

#include "lamina/base/atomic_file.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "marker_display.hpp"
#include "print/print_content.hpp"
#include "print/print_form_widget.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"
#include "window.hpp"

namespace {

using lamina::PrintContent;
using lamina::PrintFormWidget;
using lamina::test::part;
using lamina::test::waitFor;
using Display = lamina::test::MarkerDisplay;

constexpr int kBoxLayers = 15;  // 3 mm of 0.2 mm
const char* const kIdleLight = "#9a9a9a";
const char* const kBusyLight = "#f0a000";
const char* const kGoodLight = "#2e9e3f";
const char* const kBadLight = "#cc2222";

class PrintPanel : public testing::Test {
 protected:
  void SetUp() override {
    lamina::writeStl(folder_.file("box.stl"), lamina::test::boxBetween({0, 0, 0}, {10, 10, 3}));
    content_ = std::make_unique<PrintContent>(nullptr);
    content_->resize(420, 640);
    content_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(content_.get()));
  }

  void drop(const std::string& path) {
    QMimeData dragged;
    dragged.setUrls({QUrl::fromLocalFile(QString::fromStdString(path))});
    auto* form = content_->findChild<PrintFormWidget*>();
    ASSERT_NE(form, nullptr);
    QDragEnterEvent enter({1, 1}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(form, &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent release({1, 1}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(form, &release);
  }
  void press(const char* button) { QTest::mouseClick(&part<QPushButton>(*content_, button), Qt::LeftButton); }
  bool isEnabled(const char* button) { return part<QPushButton>(*content_, button).isEnabled(); }
  bool shines(const char* light, const char* colour) {
    return part<QLabel>(*content_, light).styleSheet().contains(colour);
  }
  std::string text(const char* label) { return part<QLabel>(*content_, label).text().toStdString(); }

  void slice() {
    drop(folder_.file("box.stl"));
    press("run");
    ASSERT_TRUE(waitFor([&] { return !shines("light", kBusyLight); }));
    ASSERT_TRUE(shines("light", kGoodLight)) << text("message");
    ASSERT_TRUE(waitFor([&] { return part<QSlider>(*content_, "layers").maximum() == kBoxLayers; }));
  }

  lamina::test::ScratchFolder folder_;
  std::unique_ptr<PrintContent> content_;
};

TEST_F(PrintPanel, SlicesAFileThatIsDroppedAndShowsItsRolesLayerByLayer) {
  Display layers("printed_layers");
  EXPECT_FALSE(isEnabled("print_run")) << "nothing is sliced yet";
  slice();
  EXPECT_EQ(text("message").rfind("15 layers, ", 0), 0U) << text("message");
  EXPECT_NE(text("message").find("cm³ of material"), std::string::npos) << text("message");
  for (const char* role : {"outer&nbsp;wall", "inner&nbsp;wall", "infill", "skirt"})
    EXPECT_NE(text("legend").find(role), std::string::npos) << text("legend");
  EXPECT_EQ(text("legend").find("travel"), std::string::npos);
  EXPECT_TRUE(isEnabled("print_run"));
  ASSERT_TRUE(waitFor([&] { return layers.segments("outer_wall") == 4UL * kBoxLayers; }))
      << layers.segments("outer_wall");
  auto& slider = part<QSlider>(*content_, "layers");
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Home);
  EXPECT_TRUE(waitFor([&] { return layers.segments("outer_wall") == 4U; }));
}

TEST_F(PrintPanel, TakesSettingsAndSlicesAnewAfterAChange) {
  slice();
  part<QPlainTextEdit>(*content_, "settings")
      .setPlainText("slicing.layer_height_mm = 0.3\nslicing.first_layer_height_mm = 0.3");
  EXPECT_FALSE(isEnabled("print_run")) << "the program is of another form";
  press("run");
  EXPECT_TRUE(waitFor([&] { return part<QSlider>(*content_, "layers").maximum() == 10; }));
  EXPECT_TRUE(isEnabled("print_run"));
}

TEST_F(PrintPanel, ShowsWhatTheNodeRefuses) {
  part<QPlainTextEdit>(*content_, "settings").setPlainText("infill.densty = 0.3");
  drop(folder_.file("box.stl"));
  press("run");
  ASSERT_TRUE(waitFor([&] { return shines("light", kBadLight); })) << text("message");
  EXPECT_NE(text("message").find("infill.density"), std::string::npos) << text("message");
  EXPECT_FALSE(isEnabled("print_run"));
}

TEST_F(PrintPanel, PrintsWhatItShowsAndFollowsIt) {
  slice();
  auto& slider = part<QSlider>(*content_, "layers");
  part<QCheckBox>(*content_, "follows").setChecked(true);
  bool is_followed = false;
  press("print_run");
  ASSERT_TRUE(waitFor([&] {
    is_followed = is_followed || slider.value() < kBoxLayers;
    return !shines("print_light", kBusyLight);
  }));
  EXPECT_TRUE(shines("print_light", kGoodLight)) << text("print_message");
  EXPECT_NE(text("print_message").find("printed "), std::string::npos) << text("print_message");
  EXPECT_TRUE(is_followed);
}

TEST_F(PrintPanel, HoldsGoesOnAndStops) {
  slice();
  press("print_run");
  ASSERT_TRUE(waitFor([&] { return isEnabled("pause"); }));
  press("pause");
  ASSERT_TRUE(waitFor([&] { return isEnabled("resume"); })) << text("machine_report");
  EXPECT_EQ(text("machine_report").rfind("Held", 0), 0U) << text("machine_report");
  press("resume");
  ASSERT_TRUE(waitFor([&] { return isEnabled("pause"); })) << text("machine_report");
  press("print_cancel");
  ASSERT_TRUE(waitFor([&] { return !shines("print_light", kBusyLight); }));
  EXPECT_TRUE(shines("print_light", kIdleLight)) << text("print_message");
  EXPECT_NE(text("print_message").find("heaters are off"), std::string::npos) << text("print_message");
}

TEST_F(PrintPanel, ShowsAProgramThatIsChosen) {
  slice();
  drop(folder_.file("box.gcode"));
  EXPECT_TRUE(isEnabled("print_run"));
  press("run");
  EXPECT_TRUE(shines("light", kBadLight));
  EXPECT_NE(text("message").find("press Print"), std::string::npos) << text("message");
}

TEST(RvizPrintPanel, IsFoundByRvizAndKeepsItsFormInRvizsConfiguration) {
  pluginlib::ClassLoader<rviz::Panel> loader("rviz", "rviz::Panel");
  rviz::Config config;
  {
    const auto panel = loader.createUniqueInstance("lamina/Print");
    part<QLineEdit>(*panel, "part").setText("/p/mould.stl");
    part<QPlainTextEdit>(*panel, "settings").setPlainText("walls.count = 3\nseam.placement = rear");
    panel->save(config);
  }
  const auto panel = loader.createUniqueInstance("lamina/Print");
  panel->load(config);
  EXPECT_EQ(part<QLineEdit>(*panel, "part").text().toStdString(), "/p/mould.stl");
  EXPECT_EQ(part<QPlainTextEdit>(*panel, "settings").toPlainText().toStdString(),
            "walls.count = 3\nseam.placement = rear");
}

}  // namespace
