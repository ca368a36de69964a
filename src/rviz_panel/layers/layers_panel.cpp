// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/layers_panel.hpp"

#include <pluginlib/class_list_macros.hpp>

#include <QVBoxLayout>

#include "layers/layers_content.hpp"

namespace lamina {
namespace {

constexpr char kEvery[] = "Frames Every";
constexpr char kLength[] = "Frames Length";

}  // namespace

LayersPanel::LayersPanel(QWidget* parent) : rviz::Panel(parent), content_(new LayersContent(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(content_);
  content_->changed = [this] { Q_EMIT configChanged(); };
}

void LayersPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  FrameSettings frames;
  float value = 0.0F;
  if (config.mapGetFloat(kEvery, &value)) frames.every_mm = value;
  if (config.mapGetFloat(kLength, &value)) frames.length_mm = value;
  content_->setFrames(frames);
}

void LayersPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue(kEvery, content_->frames().every_mm);
  config.mapSetValue(kLength, content_->frames().length_mm);
}

}  // namespace lamina

PLUGINLIB_EXPORT_CLASS(lamina::LayersPanel, rviz::Panel)
