// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fields/path_field.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <utility>

namespace lamina {

PathField::PathField(const QString& name, Mode mode, QString filter, QWidget* parent)
    : QWidget(parent), filter_(std::move(filter)), edit_(new QLineEdit(this)) {
  edit_->setObjectName(name);
  auto* button = new QPushButton("Browse…", this);
  button->setObjectName(name + "_browse");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
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
                             ? QFileDialog::getOpenFileName(this, "Choose a file", path(), filter_)
                             : QFileDialog::getSaveFileName(this, "Write to", path(), filter_);
  if (picked.isEmpty()) return;
  setPath(picked);
  if (chosen) chosen();
}

}  // namespace lamina
