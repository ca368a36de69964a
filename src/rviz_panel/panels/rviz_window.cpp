// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "panels/rviz_window.hpp"

#include <rviz/properties/property.h>
#include <rviz/view_controller.h>
#include <rviz/visualization_manager.h>

#include <QScrollArea>
#include <QVBoxLayout>

#include "conversions.hpp"

namespace lamina {
namespace {

constexpr double kDistance = 1.3;  // of the camera, in diagonals of what is shown

}  // namespace

void lookAt(rviz::ViewManager& views, const Box3& box) {
  rviz::ViewController* view = views.getCurrent();
  if (view == nullptr) return;
  const Point3 middle = 0.5 * (box.low + box.high);
  rviz::Property* focus = view->subProp("Focal Point");
  for (const char axis : {'X', 'Y', 'Z'}) focus->subProp(QChar(axis))->setValue(toMetres(middle[axis - 'X']));
  view->subProp("Distance")->setValue(toMetres(kDistance * (box.high - box.low).norm()));
}

void addScrolled(rviz::Panel& panel, QWidget& content) {
  auto* scroll = new QScrollArea(&panel);
  scroll->setWidget(&content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* column = new QVBoxLayout(&panel);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scroll);
}

std::vector<SettingText> savedTexts(const rviz::Config& config, const std::vector<SettingText>& keys) {
  std::vector<SettingText> texts;
  for (const auto& [key, text] : keys) {
    QString saved;
    if (config.mapGetString(QString::fromStdString(key), &saved)) texts.push_back({key, saved.toStdString()});
  }
  return texts;
}

void saveTexts(rviz::Config config, const std::vector<SettingText>& texts) {
  for (const auto& [key, text] : texts)
    config.mapSetValue(QString::fromStdString(key), QString::fromStdString(text));
}

}  // namespace lamina
