// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>

#include "print/print_form.hpp"

class QComboBox;
class QPlainTextEdit;

namespace lamina {

class PathField;

/// The form of `PrintForm` to fill in; takes files that are dropped on it as parts. Knows no ROS.
class PrintFormWidget : public QWidget {
 public:
  explicit PrintFormWidget(QWidget* parent);

  PrintForm form() const;
  void setForm(const PrintForm& form);

  std::function<void()> changed;
  std::function<void()> part_chosen;  ///< entered, chosen in the dialog or dropped

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void choosePart();

  PathField* part_;
  PathField* program_;
  QComboBox* machine_;
  QComboBox* material_;
  QComboBox* process_;
  QPlainTextEdit* settings_;
};

}  // namespace lamina
