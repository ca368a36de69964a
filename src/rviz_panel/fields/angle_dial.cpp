// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fields/angle_dial.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kGreatestAngle = 90.0;
constexpr double kMargin = 24.0;  // room for the marks
constexpr int kSize = 120;
constexpr int kLeastSize = 90;
constexpr int kFixedPointsPerDegree = 16;  // of Qt's arcs

}  // namespace

AngleDial::AngleDial(QWidget* parent) : QWidget(parent) {
  setToolTip("Angle of the layers to the bed; drag the hand");
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize AngleDial::sizeHint() const { return {kSize, kSize}; }
QSize AngleDial::minimumSizeHint() const { return {kLeastSize, kLeastSize}; }

void AngleDial::setAngle(double angle_deg) {
  angle_deg_ = angle_deg;
  update();
}

QPointF AngleDial::centre() const { return {width() - kMargin / 2.0, height() - kMargin / 2.0}; }
double AngleDial::radius() const { return std::min(width(), height()) - 1.5 * kMargin; }

QPointF AngleDial::at(double angle_deg, double distance) const {
  return centre() - distance * QPointF(std::cos(angle_deg * kDegree), std::sin(angle_deg * kDegree));
}

void AngleDial::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double r = radius();
  const QRectF circle(centre() - QPointF(r, r), QSizeF(2.0 * r, 2.0 * r));
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().base());
  painter.drawPie(circle, 90 * kFixedPointsPerDegree, 90 * kFixedPointsPerDegree);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.setBrush(Qt::NoBrush);
  painter.drawArc(circle, 90 * kFixedPointsPerDegree, 90 * kFixedPointsPerDegree);
  painter.drawLine(at(0.0, r), centre());
  for (const double mark : {0.0, 45.0, 90.0}) {
    painter.drawLine(at(mark, r), at(mark, r - 5.0));
    const QRectF label(at(mark, r + 11.0) - QPointF(12.0, 8.0), QSizeF(24.0, 16.0));
    painter.drawText(label, Qt::AlignCenter, QString::number(mark));
  }
  painter.setPen(QPen(QColor(200, 30, 30), 3.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(centre(), at(angle_deg_, r - 8.0));
  painter.drawLine(at(angle_deg_, r - 8.0), at(angle_deg_ - 7.0, r - 18.0));
  painter.drawLine(at(angle_deg_, r - 8.0), at(angle_deg_ + 7.0, r - 18.0));
}

void AngleDial::turnTo(const QPointF& place) {
  const QPointF hand = centre() - place;
  if (hand.isNull()) return;
  setAngle(std::clamp(std::round(std::atan2(hand.y(), hand.x()) / kDegree), 0.0, kGreatestAngle));
  if (turned) turned(angle_deg_);
}

void AngleDial::mousePressEvent(QMouseEvent* event) { turnTo(event->localPos()); }

void AngleDial::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) turnTo(event->localPos());
}

}  // namespace lamina
