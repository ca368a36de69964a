// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fields/run_strip.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace lamina {
namespace {

constexpr int kTickMs = 100;
constexpr int kLight = 18;  // pixels
constexpr int kWhole = 1000;

const char* colourOf(RunState state) {
  switch (state) {
    case RunState::Idle:
      return "#9a9a9a";
    case RunState::Running:
      return "#f0a000";
    case RunState::Done:
      return "#2e9e3f";
    case RunState::Failed:
      return "#cc2222";
  }
  return "#9a9a9a";
}

}  // namespace

RunState stateAfter(RunOutcome::End end) {
  switch (end) {
    case RunOutcome::End::Done:
      return RunState::Done;
    case RunOutcome::End::Stopped:
      return RunState::Idle;
    case RunOutcome::End::Failed:
      return RunState::Failed;
  }
  return RunState::Failed;
}

RunStrip::RunStrip(const RunLabels& labels, QWidget* parent)
    : QWidget(parent),
      run_(new QPushButton(labels.run, this)),
      cancel_(new QPushButton(labels.cancel, this)),
      bar_(new QProgressBar(this)),
      light_(new QLabel(this)),
      message_(new QLabel(this)),
      time_(new QLabel("0.0 s", this)) {
  const QString prefix = labels.prefix;
  run_->setObjectName(prefix + "run");
  cancel_->setObjectName(prefix + "cancel");
  bar_->setObjectName(prefix + "progress");
  light_->setObjectName(prefix + "light");
  message_->setObjectName(prefix + "message");
  time_->setObjectName(prefix + "elapsed");
  light_->setFixedSize(kLight, kLight);
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  bar_->setRange(0, kWhole);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(run_, 0, 0, 1, 2);
  grid->addWidget(cancel_, 0, 2, 1, 2);
  grid->addWidget(bar_, 1, 0, 1, 3);
  grid->addWidget(time_, 1, 3);
  grid->addWidget(light_, 2, 0, Qt::AlignTop);
  grid->addWidget(message_, 2, 1, 1, 3);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  connect(run_, &QPushButton::clicked, this, [this] { run_pressed(); });
  connect(cancel_, &QPushButton::clicked, this, [this] { cancel_pressed(); });
  connect(&tick_, &QTimer::timeout, this, [this] { showTime(); });
  showState(RunState::Idle, labels.hint);
}

void RunStrip::begin(const std::string& message) {
  clock_.start();
  tick_.start(kTickMs);
  bar_->setValue(0);
  bar_->setFormat("");
  showTime();
  showState(RunState::Running, message);
}

void RunStrip::progress(const std::string& stage, double fraction) {
  bar_->setValue(static_cast<int>(fraction * kWhole));
  bar_->setFormat(QString::fromStdString(stage) + " %p%");
}

void RunStrip::end(RunState state, const std::string& message) {
  if (tick_.isActive()) showTime();
  tick_.stop();
  bar_->setFormat("");
  bar_->setValue(state == RunState::Done ? kWhole : 0);
  showState(state, message);
}

void RunStrip::block(const std::string& reason) {
  is_blocked_ = true;
  end(RunState::Idle, reason);
}

void RunStrip::release(const std::string& hint) {
  is_blocked_ = false;
  end(RunState::Idle, hint);
}

void RunStrip::showState(RunState state, const std::string& message) {
  state_ = state;
  light_->setStyleSheet(QString("background: %1; border: 1px solid #555; border-radius: %2px;")
                            .arg(colourOf(state))
                            .arg(kLight / 2));
  message_->setText(QString::fromStdString(message));
  run_->setEnabled(state != RunState::Running && !is_blocked_);
  cancel_->setEnabled(state == RunState::Running);
}

void RunStrip::showTime() {
  time_->setText(QString("%1 s").arg(static_cast<double>(clock_.elapsed()) / 1000.0, 0, 'f', 1));
}

}  // namespace lamina
