// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fields/position_field.hpp"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>

namespace lamina {
namespace {

constexpr double kGreatest = 1e6;  // mm
constexpr int kDecimals = 2;

}  // namespace

PositionField::PositionField(const QString& name, const QString& label, std::size_t coordinates,
                             QWidget* parent)
    : QWidget(parent), is_given_(new QCheckBox(label, this)) {
  is_given_->setObjectName(name);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(is_given_, 1);
  for (std::size_t i = 0; i < coordinates; ++i) {
    auto* number = new QDoubleSpinBox(this);
    number->setObjectName(name + "_" + QChar("xyz"[i]));
    number->setRange(-kGreatest, kGreatest);
    number->setDecimals(kDecimals);
    number->setPrefix(QString(QChar("xyz"[i])) + " ");
    number->setToolTip("[mm]");
    number->setButtonSymbols(QAbstractSpinBox::NoButtons);
    number->setMinimumWidth(64);
    number->setMaximumWidth(90);
    number->setEnabled(false);
    row->addWidget(number);
    coordinates_.push_back(number);
    connect(number, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
      if (changed) changed();
    });
  }
  connect(is_given_, &QCheckBox::toggled, this, [this](bool is_given) {
    for (QDoubleSpinBox* number : coordinates_) number->setEnabled(is_given);
    if (changed) changed();
  });
}

std::vector<double> PositionField::position() const {
  std::vector<double> position;
  if (!is_given_->isChecked()) return position;
  for (const QDoubleSpinBox* number : coordinates_) position.push_back(number->value());
  return position;
}

void PositionField::setPosition(const std::vector<double>& position) {
  is_given_->setChecked(!position.empty());
  for (std::size_t i = 0; i < position.size(); ++i) coordinates_[i]->setValue(position[i]);
}

}  // namespace lamina
