// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path_field.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace lamina {
namespace {

const char* const kFilter = "Programs (*.gcode);;All files (*)";

}  // namespace

PathField::PathField(const QString& name, Mode mode, QWidget* parent)
    : QWidget(parent), edit_(new QLineEdit(this)) {
  edit_->setObjectName(name);
  auto* button = new QPushButton("Browse…", this);
  button->setObjectName(name + "_browse");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(edit_, 1);
  row->addWidget(button);
  connect(button, &QPushButton::clicked, this, [this, mode] { browse(mode); });
  connect(edit_, &QLineEdit::editingFinished, this, [this] {
    if (chosen) chosen();
  });
  connect(edit_, &QLineEdit::textChanged, this, [this] {
    if (edited) edited();
  });
}

QString PathField::path() const { return edit_->text().trimmed(); }
void PathField::setPath(const QString& path) {
  edit_->setText(path);
  edit_->setToolTip(path);
}
void PathField::setHint(const QString& text) { edit_->setPlaceholderText(text); }

void PathField::browse(Mode mode) {
  const QString picked = mode == Mode::Open
                             ? QFileDialog::getOpenFileName(this, "Choose a program", path(), kFilter)
                             : QFileDialog::getSaveFileName(this, "Write to", path(), kFilter);
  if (picked.isEmpty()) return;
  setPath(picked);
  if (chosen) chosen();
}

}  // namespace lamina
