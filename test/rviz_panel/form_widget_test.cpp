// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Types and clicks in a real window.
#include "incline/form_widget.hpp"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QtTest/QTest>
#include <cmath>

#include "fields/angle_dial.hpp"
#include "window.hpp"

namespace {

using lamina::FormWidget;
using lamina::InclineForm;
using lamina::test::part;

void type(QWidget& field, const QString& text) {
  QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(&field, text);
  QTest::keyClick(&field, Qt::Key_Return);
}

class FormWindow : public testing::Test {
 protected:
  void SetUp() override {
    form_.source_chosen = [this](const std::string& path) { chosen_.push_back(path); };
    form_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&form_));
  }

  FormWidget form_{nullptr};
  std::vector<std::string> chosen_;
};

TEST_F(FormWindow, BeginsWithThe45DegAboutXOfTheMethod) {
  const InclineForm form = form_.form();
  EXPECT_DOUBLE_EQ(form.angle_deg, 45.0);
  EXPECT_EQ(form.axis, "x");
  EXPECT_EQ(form.machine, "");
  EXPECT_TRUE(form.table_position_mm.empty());
  EXPECT_TRUE(form.final_position_mm.empty());
  EXPECT_TRUE(chosen_.empty());
}

TEST_F(FormWindow, NamesTheOutputAfterTheSourceUntilThePersonDoes) {
  type(part<QLineEdit>(form_, "source"), "/p/Cubo.gcode");
  EXPECT_EQ(form_.form().output, "/p/Cubo_rotate.gcode");
  type(part<QLineEdit>(form_, "source"), "/p/blade.gcode");
  EXPECT_EQ(form_.form().output, "/p/blade_rotate.gcode");
  type(part<QLineEdit>(form_, "output"), "/p/mine.gcode");
  type(part<QLineEdit>(form_, "source"), "/p/mould.gcode");
  EXPECT_EQ(form_.form().output, "/p/mine.gcode");
  EXPECT_EQ(chosen_, (std::vector<std::string>{"/p/Cubo.gcode", "/p/blade.gcode", "/p/mould.gcode"}));
}

TEST_F(FormWindow, TurnsDialAndNumberTogether) {
  auto& number = part<QDoubleSpinBox>(form_, "angle");
  auto& dial = dynamic_cast<lamina::AngleDial&>(*number.parentWidget()->findChild<QWidget*>("dial"));
  type(number, "30");
  EXPECT_DOUBLE_EQ(dial.angle(), 30.0);
  const QPoint hub(dial.width() - 12, dial.height() - 12);
  const auto onDial = [&](double deg) {
    return hub - QPoint(static_cast<int>(std::round(60.0 * std::cos(deg * M_PI / 180.0))),
                        static_cast<int>(std::round(60.0 * std::sin(deg * M_PI / 180.0))));
  };
  QTest::mouseClick(&dial, Qt::LeftButton, {}, onDial(60.0));
  EXPECT_NEAR(form_.form().angle_deg, 60.0, 1.0);
  EXPECT_DOUBLE_EQ(number.value(), dial.angle());
  QTest::mouseClick(&dial, Qt::LeftButton, {}, onDial(90.0));
  EXPECT_DOUBLE_EQ(form_.form().angle_deg, 90.0);
  QTest::mouseClick(&dial, Qt::LeftButton, {}, hub + QPoint(-60, 8));
  EXPECT_DOUBLE_EQ(form_.form().angle_deg, 0.0) << "below the flat end";
}

TEST_F(FormWindow, TakesAVectorAsAxis) {
  auto& choice = part<QComboBox>(form_, "axis");
  EXPECT_FALSE(part<QWidget>(form_, "axis_x").isVisible());
  QTest::keyClick(&choice, Qt::Key_Down);
  EXPECT_EQ(form_.form().axis, "y");
  QTest::keyClick(&choice, Qt::Key_End);
  ASSERT_TRUE(part<QWidget>(form_, "axis_x").isVisible());
  type(part<QDoubleSpinBox>(form_, "axis_x"), "-1");
  type(part<QDoubleSpinBox>(form_, "axis_z"), "0.25");
  EXPECT_EQ(form_.form().axis, "-1,0,0.25");
}

TEST_F(FormWindow, HoldsPositionsOnlyIfTheyAreTicked) {
  part<QTabWidget>(form_, "tabs").setCurrentIndex(0);
  EXPECT_FALSE(part<QWidget>(form_, "table_position_x").isEnabled());
  QTest::mouseClick(&part<QCheckBox>(form_, "table_position"), Qt::LeftButton, {}, QPoint(8, 8));
  type(part<QDoubleSpinBox>(form_, "table_position_x"), "650");
  type(part<QDoubleSpinBox>(form_, "table_position_y"), "1250.5");
  EXPECT_EQ(form_.form().table_position_mm, (std::vector<double>{650.0, 1250.5}));
  QTest::mouseClick(&part<QCheckBox>(form_, "final_position"), Qt::LeftButton, {}, QPoint(8, 8));
  type(part<QDoubleSpinBox>(form_, "final_position_z"), "900");
  EXPECT_EQ(form_.form().final_position_mm, (std::vector<double>{0.0, 0.0, 900.0}));
  QTest::mouseClick(&part<QCheckBox>(form_, "table_position"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_TRUE(form_.form().table_position_mm.empty());
}

TEST_F(FormWindow, TakesCodeOfSeveralLines) {
  part<QTabWidget>(form_, "tabs").setCurrentIndex(1);
  auto& begin_code = part<QPlainTextEdit>(form_, "begin_code");
  QTest::keyClicks(&begin_code, "M104 S200");
  QTest::keyClick(&begin_code, Qt::Key_Return);
  QTest::keyClicks(&begin_code, "M140 S90");
  part<QTabWidget>(form_, "tabs").setCurrentIndex(2);
  QTest::keyClicks(&part<QPlainTextEdit>(form_, "end_code"), "M84");
  EXPECT_EQ(form_.form().begin_code, "M104 S200\nM140 S90");
  EXPECT_EQ(form_.form().end_code, "M84");
}

TEST_F(FormWindow, ShowsTheFormItIsGiven) {
  InclineForm given;
  given.source = "/p/a.gcode";
  given.output = "/p/b.gcode";
  given.angle_deg = 12.5;
  given.axis = "0,-1,0.5";
  given.machine = "large_gantry_45";
  given.begin_code = "M104";
  given.end_code = "M84\n";
  given.table_position_mm = {1.0, 2.0};
  given.final_position_mm = {3.0, 4.0, 5.0};
  given.drops_build_aids = true;
  int changes = 0;
  form_.changed = [&changes] { ++changes; };
  form_.setForm(given);
  EXPECT_GT(changes, 0);
  const auto texts = lamina::textsOf(given);
  const auto shown = lamina::textsOf(form_.form());
  ASSERT_EQ(shown.size(), texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(shown[i].text, texts[i].text) << texts[i].key;
}

}  // namespace
