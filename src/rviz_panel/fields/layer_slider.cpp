// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fields/layer_slider.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace lamina {
namespace {

constexpr int kPauseMs = 40;

}  // namespace

LayerSlider::LayerSlider(QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal, this)), label_(new QLabel("–", this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  slider_->setObjectName("layers");
  slider_->setRange(0, 0);
  slider_->setEnabled(false);
  label_->setObjectName("shown_layers");
  row->addWidget(new QLabel("Layers", this));
  row->addWidget(slider_, 1);
  row->addWidget(label_);
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(slider_, &QSlider::valueChanged, this, [this](int layers) {
    label_->setText(QString("%1 of %2").arg(layers).arg(slider_->maximum()));
    if (!pause_.isActive()) pause_.start();
  });
  connect(&pause_, &QTimer::timeout, this, [this] {
    if (slid) slid(shownLayers());
  });
}

void LayerSlider::setLayerCount(std::size_t layers) {
  const int count = static_cast<int>(layers);
  {
    const QSignalBlocker blocker(slider_);
    slider_->setRange(count > 0 ? 1 : 0, count);
    slider_->setValue(count);
  }
  slider_->setEnabled(count > 1);
  label_->setText(count > 0 ? QString("%1 of %1").arg(count) : QString("–"));
}

std::size_t LayerSlider::shownLayers() const { return static_cast<std::size_t>(slider_->value()); }

void LayerSlider::slideTo(std::size_t layers) { slider_->setValue(static_cast<int>(layers)); }

}  // namespace lamina
