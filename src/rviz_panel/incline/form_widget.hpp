// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "incline/incline_form.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QPlainTextEdit;

namespace lamina {

class AngleDial;
class AxisField;
class PathField;
class PositionField;

/// The form of `InclineForm` to fill in. Knows no ROS.
class FormWidget : public QWidget {
 public:
  explicit FormWidget(QWidget* parent);

  InclineForm form() const;
  void setForm(const InclineForm& form);

  std::function<void(const std::string& path)> source_chosen;
  std::function<void()> changed;

 private:
  QWidget* makeFiles();
  QWidget* makeTurn();
  QWidget* makePlace();
  QWidget* makeCode(const QString& name, const QString& hint, QPlainTextEdit*& edit);
  void joinDialAndNumber();
  void chooseSource();
  void notifyChange();

  PathField* source_;
  PathField* output_;
  AngleDial* dial_;
  QDoubleSpinBox* angle_;
  AxisField* axis_;
  PositionField* table_;
  PositionField* final_;
  QCheckBox* drops_aids_;
  QComboBox* machine_;
  QPlainTextEdit* begin_code_ = nullptr;
  QPlainTextEdit* end_code_ = nullptr;
  std::string shown_source_;  ///< whose default the output field was given
};

}  // namespace lamina
