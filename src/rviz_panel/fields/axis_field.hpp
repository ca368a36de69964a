// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <string>

class QComboBox;
class QDoubleSpinBox;

namespace lamina {

/// Choice of x, y, z or a vector, whose three numbers are then asked for.
class AxisField : public QWidget {
 public:
  explicit AxisField(QWidget* parent);

  /// As `incline.axis`: x, y, z, or three numbers with commas between them.
  std::string axis() const;
  /// @param axis  as above
  void setAxis(const std::string& axis);

  std::function<void()> changed;

 private:
  QComboBox* choice_;
  std::array<QDoubleSpinBox*, 3> vector_{};
};

}  // namespace lamina
