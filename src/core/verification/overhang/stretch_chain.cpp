// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/overhang/stretch_chain.hpp"

#include <algorithm>
#include <utility>

namespace lamina {
namespace {

constexpr double kJoined = 1e-6;  // mm: as paths join

double distanceToSegment(const Point3& point, const Point3& start, const Point3& end) {
  const Point3 along = end - start;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((point - start).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - start - t * along).norm();
}

}  // namespace

void StretchChain::lay(const DepositedPiece& piece) {
  if (end_ && (piece.start - *end_).norm() > kJoined) stop();
  LayerOverhang& layer = report_.layers[piece.at.layer];
  layer.deposited_mm += piece.length_mm;
  const bool begins_run = !end_;
  end_ = piece.end;
  if (begins_run) ++report_.runs;
  if (piece.is_carried) return close(kindIfCarriedAgain());
  if (begins_run) ++layer.starts_in_air;
  if (!stretch_) {
    stretch_.emplace();
    stretch_->at = piece.at;
    stretch_->role = piece.role;
    stretch_->begins_run = begins_run;
    stretch_->width_mm = piece.section.width_mm;
    stretch_->points = {piece.start};
  }
  stretch_->length_mm += piece.length_mm;
  if (stretch_->points.size() > 1 && piece.at == last_)
    stretch_->points.back() = piece.end;
  else if (piece.end != piece.start)
    stretch_->points.push_back(piece.end);
  last_ = piece.at;
}

void StretchChain::stop() {
  close(StretchKind::Overhang);
  end_.reset();
}

OverhangReport StretchChain::finish() {
  stop();
  return std::exchange(report_, OverhangReport());
}

StretchKind StretchChain::kindIfCarriedAgain() const {
  if (!stretch_ || stretch_->begins_run) return StretchKind::Overhang;
  const std::vector<Point3>& points = stretch_->points;
  const bool is_straight = std::all_of(points.begin(), points.end(), [&](const Point3& point) {
    return distanceToSegment(point, points.front(), points.back()) <= 0.5 * stretch_->width_mm;
  });
  return is_straight ? StretchKind::Bridge : StretchKind::Overhang;
}

void StretchChain::close(StretchKind kind) {
  if (!stretch_) return;
  stretch_->kind = kind;
  LayerOverhang& layer = report_.layers[stretch_->at.layer];
  (kind == StretchKind::Bridge ? layer.bridge_mm : layer.overhang_mm) += stretch_->length_mm;
  report_.stretches.push_back(std::move(*stretch_));
  stretch_.reset();
}

}  // namespace lamina
