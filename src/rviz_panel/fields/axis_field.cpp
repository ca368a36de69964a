// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fields/axis_field.hpp"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QStringList>

namespace lamina {
namespace {

constexpr int kVector = 3;  // index of that choice, after x, y and z
constexpr int kAxisDecimals = 4;
constexpr int kNarrow = 48;  // pixels
constexpr double kGreatestAxis = 1000.0;

}  // namespace

AxisField::AxisField(QWidget* parent) : QWidget(parent), choice_(new QComboBox(this)) {
  choice_->setObjectName("axis");
  choice_->addItems({"x", "y", "z", "vector"});
  choice_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  choice_->setToolTip("Axis of the turn, right-handed; for the other sense give the opposite vector");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(choice_, 0, Qt::AlignLeft);
  for (std::size_t i = 0; i < 3; ++i) {
    vector_[i] = new QDoubleSpinBox(this);
    vector_[i]->setObjectName(QString("axis_%1").arg("xyz"[i]));
    vector_[i]->setRange(-kGreatestAxis, kGreatestAxis);
    vector_[i]->setDecimals(kAxisDecimals);
    vector_[i]->setSingleStep(0.1);
    vector_[i]->setButtonSymbols(QAbstractSpinBox::NoButtons);
    vector_[i]->setMinimumWidth(kNarrow);  // the vector must not widen the panel
    vector_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    vector_[i]->hide();
    row->addWidget(vector_[i], 1);
    connect(vector_[i], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
      if (changed) changed();
    });
  }
  vector_[0]->setValue(1.0);
  connect(choice_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
    for (QDoubleSpinBox* number : vector_) number->setVisible(index == kVector);
    if (changed) changed();
  });
}

std::string AxisField::axis() const {
  if (choice_->currentIndex() != kVector) return choice_->currentText().toStdString();
  QStringList numbers;
  for (const QDoubleSpinBox* number : vector_) numbers << QString::number(number->value(), 'g', 10);
  return numbers.join(",").toStdString();
}

void AxisField::setAxis(const std::string& axis) {
  const QStringList numbers = QString::fromStdString(axis).split(',');
  if (numbers.size() == 3)
    for (std::size_t i = 0; i < 3; ++i) vector_[i]->setValue(numbers[static_cast<int>(i)].toDouble());
  choice_->setCurrentIndex(numbers.size() == 3 ? kVector : choice_->findText(numbers[0]));
}

}  // namespace lamina
