// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline/panel_content.hpp"

#include <QFileInfo>
#include <QVBoxLayout>

#include "fields/layer_slider.hpp"
#include "fields/run_strip.hpp"
#include "incline/form_widget.hpp"
#include "lamina/base/error.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr int kPollMs = 30;

}  // namespace

PanelContent::PanelContent(QWidget* parent, const std::string& action)
    : QWidget(parent),
      form_(new FormWidget(this)),
      strip_(new RunStrip({}, this)),
      slider_(new LayerSlider(this)),
      client_(action),
      source_reader_(names::kBedFrame),
      inclined_reader_(names::kBedFrame) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(form_);
  column->addWidget(strip_);
  column->addWidget(slider_);
  column->addStretch();
  form_->changed = [this] {
    if (changed) changed();
  };
  form_->source_chosen = [this](const std::string& path) { drawSource(path); };
  strip_->run_pressed = [this] { run(); };
  slider_->slid = [this](std::size_t layers) { view_.showLayers(layers); };
  strip_->cancel_pressed = [this] { client_.cancel(); };
  client_.progressed = [this](const std::string& stage, double fraction) {
    strip_->progress(stage, fraction);
  };
  client_.ended = [this](const RunOutcome& outcome) { end(outcome); };
  connect(&poll_, &QTimer::timeout, this, [this] {
    client_.poll();
    view_.poll();
  });
  poll_.start(kPollMs);
}

PanelContent::~PanelContent() = default;

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

void PanelContent::end(const RunOutcome& outcome) {
  strip_->end(stateAfter(outcome.end), outcome.message);
  if (outcome.end == RunOutcome::End::Done) drawInclined(outcome.output);
}

void PanelContent::drawSource(const std::string& path) {
  inclined_reader_.stop();
  view_.removeInclined();
  view_.showSource({});
  notifyShown();
  const QFileInfo file(QString::fromStdString(path));
  drawn_source_time_ = file.lastModified();
  if (!file.isFile()) return source_reader_.stop();
  source_reader_.read(path, [this](DrawnPart part) {
    if (!part.failure.empty() && !client_.isRunning())
      strip_->end(RunState::Idle, "not drawn: " + part.failure);
    view_.showSource(std::move(part));
    notifyShown();
  });
}

void PanelContent::drawInclined(const std::string& path) {
  inclined_reader_.read(path, [this](DrawnPart part) {
    if (!part.failure.empty()) strip_->end(RunState::Done, "written, but not drawn: " + part.failure);
    view_.showInclined(std::move(part));
    notifyShown();
  });
}

void PanelContent::notifyShown() {
  slider_->setLayerCount(view_.layerCount());
  view_.showLayers(slider_->shownLayers());
  const std::optional<Box3> box = view_.box();
  if (box && shown) shown(*box);
}

}  // namespace lamina
