// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print/print_panel.hpp"

#include <rviz/visualization_manager.h>
#include <pluginlib/class_list_macros.hpp>

#include "panels/rviz_window.hpp"
#include "print/print_content.hpp"

namespace lamina {

PrintPanel::PrintPanel(QWidget* parent) : rviz::Panel(parent), content_(new PrintContent(this)) {
  addScrolled(*this, *content_);
  content_->changed = [this] { Q_EMIT configChanged(); };
  content_->shown = [this](const Box3& box) {
    if (vis_manager_ != nullptr) lookAt(*vis_manager_->getViewManager(), box);
  };
}

void PrintPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  content_->load(savedTexts(config, textsOf(PrintForm())));
}

void PrintPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  saveTexts(config, textsOf(content_->form()));
}

}  // namespace lamina

PLUGINLIB_EXPORT_CLASS(lamina::PrintPanel, rviz::Panel)
