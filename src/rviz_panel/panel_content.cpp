// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "panel_content.hpp"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "form_widget.hpp"
#include "lamina/base/error.hpp"
#include "names.hpp"
#include "run_strip.hpp"

namespace lamina {
namespace {

constexpr int kPollMs = 30;
constexpr int kSlideMs = 40;

}  // namespace

PanelContent::PanelContent(QWidget* parent, const std::string& action)
    : QWidget(parent),
      form_(new FormWidget(this)),
      strip_(new RunStrip(this)),
      client_(action),
      view_(names::kBedFrame),
      source_reader_(names::kBedFrame),
      inclined_reader_(names::kBedFrame) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(form_);
  column->addWidget(strip_);
  column->addWidget(makeSlider());
  column->addStretch();
  form_->changed = [this] {
    if (changed) changed();
  };
  form_->source_chosen = [this](const std::string& path) { drawSource(path); };
  strip_->run_pressed = [this] { run(); };
  strip_->cancel_pressed = [this] { client_.cancel(); };
  client_.progressed = [this](const std::string& stage, double fraction) {
    strip_->progress(stage, fraction);
  };
  client_.ended = [this](const InclineOutcome& outcome) { end(outcome); };
  connect(&poll_, &QTimer::timeout, this, [this] {
    client_.poll();
    view_.poll();
  });
  poll_.start(kPollMs);
}

PanelContent::~PanelContent() = default;

QWidget* PanelContent::makeSlider() {
  auto* widget = new QWidget(this);
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  slider_ = new QSlider(Qt::Horizontal, widget);
  slider_->setObjectName("layers");
  slider_->setRange(0, 0);
  slider_->setEnabled(false);
  shown_layers_ = new QLabel("–", widget);
  shown_layers_->setObjectName("shown_layers");
  row->addWidget(new QLabel("Layers", widget));
  row->addWidget(slider_, 1);
  row->addWidget(shown_layers_);
  slide_.setSingleShot(true);
  slide_.setInterval(kSlideMs);
  connect(slider_, &QSlider::valueChanged, this, [this](int layers) {
    shown_layers_->setText(QString("%1 of %2").arg(layers).arg(slider_->maximum()));
    if (!slide_.isActive()) slide_.start();
  });
  connect(&slide_, &QTimer::timeout, this, [this] { showLayers(); });
  return widget;
}

InclineForm PanelContent::form() const { return form_->form(); }

void PanelContent::load(const std::vector<SettingText>& texts) {
  try {
    form_->setForm(formFrom(texts));
  } catch (const Error& error) {
    strip_->end(RunState::Failed, std::string("the saved form is not taken: ") + error.what());
  }
}

void PanelContent::run() {
  try {
    const InclineRequest request = requestOf(form_->form());
    if (QFileInfo(QString::fromStdString(request.program)).lastModified() != drawn_source_time_)
      drawSource(request.program);  // it was written anew
    client_.run(request);
    strip_->begin("running");
  } catch (const Error& error) {
    strip_->end(RunState::Failed, error.what());
  }
}

void PanelContent::end(const InclineOutcome& outcome) {
  switch (outcome.end) {
    case InclineOutcome::End::Written:
      strip_->end(RunState::Done, outcome.message);
      return drawInclined(outcome.output);
    case InclineOutcome::End::Stopped:
      return strip_->end(RunState::Idle, outcome.message);
    case InclineOutcome::End::Failed:
      return strip_->end(RunState::Failed, outcome.message);
  }
}

void PanelContent::drawSource(const std::string& path) {
  inclined_reader_.stop();
  view_.removeInclined();
  view_.showSource({});
  tellShown();
  const QFileInfo file(QString::fromStdString(path));
  drawn_source_time_ = file.lastModified();
  if (!file.isFile()) return source_reader_.stop();
  source_reader_.read(path, [this](DrawnPart part) {
    if (!part.failure.empty() && !client_.isRunning())
      strip_->end(RunState::Idle, "not drawn: " + part.failure);
    view_.showSource(std::move(part));
    tellShown();
  });
}

void PanelContent::drawInclined(const std::string& path) {
  inclined_reader_.read(path, [this](DrawnPart part) {
    if (!part.failure.empty()) strip_->end(RunState::Done, "written, but not drawn: " + part.failure);
    view_.showInclined(std::move(part));
    tellShown();
  });
}

void PanelContent::tellShown() {
  const int layers = static_cast<int>(view_.layerCount());
  {
    const QSignalBlocker blocker(slider_);
    slider_->setRange(layers > 0 ? 1 : 0, layers);
    slider_->setValue(layers);
  }
  slider_->setEnabled(layers > 1);
  shown_layers_->setText(layers > 0 ? QString("%1 of %1").arg(layers) : QString("–"));
  showLayers();
  const std::optional<Box3> box = view_.box();
  if (box && shown) shown(*box);
}

void PanelContent::showLayers() { view_.showLayers(static_cast<std::size_t>(slider_->value())); }

}  // namespace lamina
