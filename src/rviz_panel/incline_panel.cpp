// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline_panel.hpp"

#include <rviz/properties/property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <pluginlib/class_list_macros.hpp>

#include <QScrollArea>
#include <QVBoxLayout>

#include "conversions.hpp"
#include "names.hpp"
#include "panel_content.hpp"

namespace lamina {
namespace {

constexpr double kDistance = 1.3;  // of the camera, in diagonals of what is shown

/// Leads the camera to a box [mm] from where it looks now, if it is one that orbits.
void lookAt(rviz::ViewManager& views, const Box3& box) {
  rviz::ViewController* view = views.getCurrent();
  if (view == nullptr) return;
  const Point3 middle = 0.5 * (box.low + box.high);
  rviz::Property* focus = view->subProp("Focal Point");
  for (const char axis : {'X', 'Y', 'Z'}) focus->subProp(QChar(axis))->setValue(toMetres(middle[axis - 'X']));
  view->subProp("Distance")->setValue(toMetres(kDistance * (box.high - box.low).norm()));
}

/// What RViz's configuration holds of the form.
std::vector<SettingText> savedIn(const rviz::Config& config) {
  std::vector<SettingText> texts;
  for (const auto& [key, text] : textsOf({})) {
    QString saved;
    if (config.mapGetString(QString::fromStdString(key), &saved)) texts.push_back({key, saved.toStdString()});
  }
  return texts;
}

}  // namespace

InclinePanel::InclinePanel(QWidget* parent)
    : rviz::Panel(parent), content_(new PanelContent(this, names::kInclineGcode)) {
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scroll);
  content_->changed = [this] { Q_EMIT configChanged(); };
  content_->shown = [this](const Box3& box) {
    if (vis_manager_ != nullptr) lookAt(*vis_manager_->getViewManager(), box);
  };
}

void InclinePanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  content_->load(savedIn(config));
}

void InclinePanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  for (const auto& [key, text] : textsOf(content_->form()))
    config.mapSetValue(QString::fromStdString(key), QString::fromStdString(text));
}

}  // namespace lamina

PLUGINLIB_EXPORT_CLASS(lamina::InclinePanel, rviz::Panel)
