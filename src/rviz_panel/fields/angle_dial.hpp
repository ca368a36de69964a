// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>

namespace lamina {

/// A quarter circle with a hand, from 0 deg (flat, left) to 90 deg (upright), set by the mouse. It has marks
/// at 0, 45 and 90 deg; the mouse snaps to whole degrees.
class AngleDial : public QWidget {
 public:
  explicit AngleDial(QWidget* parent);

  double angle() const { return angle_deg_; }
  void setAngle(double angle_deg);

  std::function<void(double angle_deg)> turned;  ///< by the mouse

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  QPointF centre() const;
  double radius() const;
  QPointF at(double angle_deg, double distance) const;
  void turnTo(const QPointF& place);

  double angle_deg_ = 45.0;
};

}  // namespace lamina
