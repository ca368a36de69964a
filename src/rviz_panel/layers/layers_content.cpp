// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/layers_content.hpp"

#include <ros/single_subscriber_publisher.h>

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "conversions.hpp"
#include "fields/layer_slider.hpp"
#include "lamina/base/error.hpp"
#include "markers/frame_markers.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr int kLayersPollMs = 30;

QDoubleSpinBox* millimetres(const char* name, double high, const char* none) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(0.0, high);
  box->setDecimals(1);
  box->setSuffix(" mm");
  box->setSpecialValueText(none);
  box->setKeyboardTracking(false);
  return box;
}

}  // namespace

LayersContent::LayersContent(QWidget* parent)
    : QWidget(parent),
      slider_(new LayerSlider(this)),
      every_(millimetres("frames_every", 1000.0, "none")),
      length_(millimetres("frames_length", 100.0, "")),
      part_(new QLabel("no toolpath yet", this)) {
  part_->setObjectName("part");
  length_->setMinimum(0.1);
  setFrames({});
  auto* column = new QVBoxLayout(this);
  column->addWidget(part_);
  column->addWidget(slider_);
  auto* form = new QFormLayout;
  form->addRow("Frames every", every_);
  form->addRow("Length of axes", length_);
  column->addLayout(form);
  column->addStretch();
  slider_->slid = [this](std::size_t layers) {
    const visualization_msgs::MarkerArray changes = shown_.show(layers);
    if (!changes.markers.empty()) publisher_.publish(changes);
  };
  for (QDoubleSpinBox* box : {every_, length_})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] {
      draw();
      if (changed) changed();
    });
  node_.setCallbackQueue(&queue_);
  publisher_ = node_.advertise<visualization_msgs::MarkerArray>(
      names::kShownLayers, 10,
      [this](const ros::SingleSubscriberPublisher& newcomer) { newcomer.publish(shown_.all()); });
  subscriber_ = node_.subscribe<lamina_msgs::Toolpath>(
      names::kToolpath, 1, [this](const lamina_msgs::ToolpathConstPtr& message) { take(message); });
  connect(&poll_, &QTimer::timeout, this, [this] { queue_.callAvailable(); });
  poll_.start(kLayersPollMs);
}

LayersContent::~LayersContent() = default;

FrameSettings LayersContent::frames() const { return {every_->value(), length_->value()}; }

void LayersContent::setFrames(const FrameSettings& settings) {
  const QSignalBlocker every(every_);
  const QSignalBlocker length(length_);
  every_->setValue(settings.every_mm);
  length_->setValue(settings.length_mm);
}

void LayersContent::take(const lamina_msgs::ToolpathConstPtr& message) {
  try {
    toolpath_ = fromMessage(*message).toolpath;
  } catch (const Error& error) {
    part_->setText(QString("a toolpath is not shown: ") + error.what());
    return;
  }
  part_->setText(QString::fromStdString(toolpath_.part_name));
  slider_->setLayerCount(toolpath_.layers.size());
  draw();
}

void LayersContent::draw() {
  std::vector<MarkerChunk> chunks = toolpathMarkerChunks(toolpath_, names::kPartFrame);
  for (MarkerChunk& chunk : frameMarkerChunks(toolpath_, frames(), names::kPartFrame))
    chunks.push_back(std::move(chunk));
  shown_.load(std::move(chunks), toolpath_.layers.size());
  shown_.show(slider_->shownLayers());
  publisher_.publish(shown_.all());
}

}  // namespace lamina
