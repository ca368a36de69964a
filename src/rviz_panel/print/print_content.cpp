// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print/print_content.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "fields/layer_slider.hpp"
#include "fields/role_legend.hpp"
#include "fields/run_strip.hpp"
#include "lamina/base/error.hpp"
#include "names.hpp"
#include "print/print_form_widget.hpp"

namespace lamina {
namespace {

constexpr int kPrintPollMs = 30;
const char* const kNothingToPrint = "slice a part, or choose a program";
const char* const kReady = "press Print when the machine is ready";

}  // namespace

PrintContent::PrintContent(QWidget* parent)
    : QWidget(parent),
      form_(new PrintFormWidget(this)),
      slicing_(new RunStrip({"Slice", "Cancel", "choose a part and press Slice", ""}, this)),
      legend_(new RoleLegend(this)),
      slider_(new LayerSlider(this)),
      follows_(new QCheckBox("Follow the print", this)),
      printing_(new RunStrip({"Print", "Stop", kNothingToPrint, "print_"}, this)),
      machine_(new QLabel("no machine yet", this)),
      slice_client_(names::kSlice),
      stream_client_(names::kStreamProgram),
      display_(names::kPrintedLayers),
      reader_(names::kBedFrame) {
  follows_->setObjectName("follows");
  machine_->setObjectName("machine_report");
  machine_->setWordWrap(true);
  form_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* column = new QVBoxLayout(this);
  for (QWidget* row :
       {static_cast<QWidget*>(form_), static_cast<QWidget*>(slicing_), static_cast<QWidget*>(legend_),
        static_cast<QWidget*>(slider_), static_cast<QWidget*>(follows_), static_cast<QWidget*>(printing_),
        makeHolds(), static_cast<QWidget*>(machine_)})
    column->addWidget(row);
  column->addStretch();
  printing_->block(kNothingToPrint);
  form_->part_chosen = [this] { choosePart(); };
  form_->changed = [this] {
    if (!stream_client_.isRunning() && !program_.empty()) {
      program_.clear();
      printing_->block("the form was changed; slice again");
    }
    if (changed) changed();
  };
  slicing_->run_pressed = [this] { slice(); };
  slicing_->cancel_pressed = [this] { slice_client_.cancel(); };
  printing_->run_pressed = [this] { print(); };
  printing_->cancel_pressed = [this] { stream_client_.stop(); };
  slider_->slid = [this](std::size_t layers) { display_.showLayers(layers); };
  connectClients();
  connect(&poll_, &QTimer::timeout, this, [this] {
    slice_client_.poll();
    stream_client_.poll();
    watch_.poll();
    display_.poll();
  });
  poll_.start(kPrintPollMs);
}

PrintContent::~PrintContent() = default;

QWidget* PrintContent::makeHolds() {
  auto* holds = new QWidget(this);
  auto* row = new QHBoxLayout(holds);
  row->setContentsMargins(0, 0, 0, 0);
  hold_ = new QPushButton("Pause", holds);
  go_on_ = new QPushButton("Resume", holds);
  hold_->setObjectName("pause");
  go_on_->setObjectName("resume");
  for (QPushButton* button : {hold_, go_on_}) {
    button->setEnabled(false);
    row->addWidget(button);
  }
  connect(hold_, &QPushButton::clicked, this, [this] { watch_.hold(); });
  connect(go_on_, &QPushButton::clicked, this, [this] { watch_.goOn(); });
  return holds;
}

void PrintContent::connectClients() {
  slice_client_.progressed = [this](const std::string& stage, double fraction) {
    slicing_->progress(stage, fraction);
  };
  slice_client_.ended = [this](const RunOutcome& outcome) { endSlice(outcome); };
  stream_client_.progressed = [this](const PrintProgress& progress) { showProgress(progress); };
  stream_client_.ended = [this](const RunOutcome& outcome) {
    printing_->end(stateAfter(outcome.end), outcome.message);
  };
  watch_.reported = [this](const WatchedState& report) { showReport(report); };
  watch_.refused = [this](const std::string& reason) { machine_->setText(QString::fromStdString(reason)); };
}

PrintForm PrintContent::form() const { return form_->form(); }

void PrintContent::load(const std::vector<SettingText>& texts) {
  try {
    form_->setForm(printFormFrom(texts));
  } catch (const Error& error) {
    slicing_->end(RunState::Failed, std::string("the saved form is not taken: ") + error.what());
  }
}

void PrintContent::choosePart() {
  const PrintForm form = form_->form();
  if (isProgram(form.part)) draw(form.part);
}

void PrintContent::slice() {
  try {
    slice_client_.run(requestOf(form_->form()));
    slicing_->begin("slicing");
  } catch (const Error& error) {
    slicing_->end(RunState::Failed, error.what());
  }
}

void PrintContent::endSlice(const RunOutcome& outcome) {
  slicing_->end(stateAfter(outcome.end), outcome.message);
  if (outcome.end == RunOutcome::End::Done) draw(outcome.output);
}

void PrintContent::draw(const std::string& program) {
  if (!stream_client_.isRunning()) {
    program_ = program;
    printing_->release(kReady);
  }
  reader_.read(program, [this](DrawnPart part) { showDrawn(std::move(part)); });
}

void PrintContent::showDrawn(DrawnPart part) {
  if (!part.failure.empty()) slicing_->end(slicing_->state(), "not drawn: " + part.failure);
  legend_->setRoles(part.roles);
  display_.show(std::move(part));
  slider_->setLayerCount(display_.layerCount());
  if (display_.box() && shown) shown(*display_.box());
}

void PrintContent::print() {
  stream_client_.print(program_);
  printing_->begin("printing " + program_);
}

void PrintContent::showProgress(const PrintProgress& progress) {
  printing_->progress(progress.state, progress.fraction);
  if (follows_->isChecked() && progress.layer >= 0)
    slider_->slideTo(static_cast<std::size_t>(progress.layer) + 1);
}

void PrintContent::showReport(const WatchedState& report) {
  machine_->setText(QString::fromStdString(report.text));
  hold_->setEnabled(report.is_printing);
  go_on_->setEnabled(report.is_held);
}

}  // namespace lamina
