// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

class QCheckBox;
class QDoubleSpinBox;

namespace lamina {

/// A position that may be left out: a box to tick, and its coordinates [mm].
class PositionField : public QWidget {
 public:
  /// @param name  of the box to tick; its coordinates are <name>_x and so on
  /// @param coordinates  how many: 2 for x, y; 3 for x, y, z
  PositionField(const QString& name, const QString& label, std::size_t coordinates, QWidget* parent);

  /// The coordinates; none if the box is not ticked.
  std::vector<double> position() const;
  /// @param position  as many as the field has, or none
  void setPosition(const std::vector<double>& position);

  std::function<void()> changed;

 private:
  QCheckBox* is_given_;
  std::vector<QDoubleSpinBox*> coordinates_;
};

}  // namespace lamina
