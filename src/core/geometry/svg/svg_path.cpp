// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/svg/svg_path.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kFlatness = 0.005;  // mm
constexpr int kMostPieces = 100000;

/// Pieces in which a curve whose second derivative is at most that [mm] lies within the flatness of its
/// chords.
int piecesFor(double second_derivative_mm) {
  const double pieces = std::ceil(std::sqrt(second_derivative_mm / (8.0 * kFlatness)));
  return static_cast<int>(std::clamp(pieces, 1.0, double{kMostPieces}));
}

/// Of a length, by a map of the plane: its greater singular value.
double greatestStretch(const Eigen::Matrix2d& map) {
  const double kept = std::hypot(map(0, 0) + map(1, 1), map(1, 0) - map(0, 1));
  const double mirrored = std::hypot(map(0, 0) - map(1, 1), map(1, 0) + map(0, 1));
  return 0.5 * (kept + mirrored);
}

/// Path data as commands and numbers.
class PathData {
 public:
  explicit PathData(std::string_view text) : text_(text) {}

  bool isAtEnd() {
    skip();
    return text_.empty();
  }
  /// The command letter that comes next, if one does.
  std::optional<char> command() {
    skip();
    if (text_.empty() || std::isalpha(static_cast<unsigned char>(text_[0])) == 0) return std::nullopt;
    const char letter = text_[0];
    text_.remove_prefix(1);
    return letter;
  }
  double number() {
    skip();
    if (!text_.empty() && text_[0] == '+') text_.remove_prefix(1);
    double value = 0.0;
    const auto result = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    is_broken_ = is_broken_ || result.ec != std::errc{} || !std::isfinite(value);
    text_.remove_prefix(is_broken_ ? text_.size() : static_cast<std::size_t>(result.ptr - text_.data()));
    return value;
  }
  /// 0 or 1, behind which nothing need stand before the next number.
  bool flag() {
    skip();
    is_broken_ = is_broken_ || text_.empty() || (text_[0] != '0' && text_[0] != '1');
    const bool is_set = !is_broken_ && text_[0] == '1';
    text_.remove_prefix(std::min<std::size_t>(1, text_.size()));
    return is_set;
  }
  void refuse() { is_broken_ = true; }
  bool isBroken() const { return is_broken_; }

 private:
  void skip() {
    while (!text_.empty() && (std::isspace(static_cast<unsigned char>(text_[0])) != 0 || text_[0] == ','))
      text_.remove_prefix(1);
  }

  std::string_view text_;
  bool is_broken_ = false;
};

/// Runs commands; a curve that goes on smoothly needs the control point before it.
class PathRunner {
 public:
  PathRunner(PathData& data, SvgPen& pen) : data_(data), pen_(pen) {}

  void run(char letter) {
    const bool is_relative = std::islower(static_cast<unsigned char>(letter)) != 0;
    from_ = is_relative ? pen_.at() : Point2(Point2::Zero());
    const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    draw(upper);
    last_ = upper;
  }

 private:
  Point2 point() {
    const double x = data_.number();
    return from_ + Point2(x, data_.number());
  }

  void draw(char letter) {
    switch (letter) {
      case 'M':
        return pen_.moveTo(point());
      case 'L':
        return pen_.lineTo(point());
      case 'H':
        return pen_.lineTo({from_.x() + data_.number(), pen_.at().y()});
      case 'V':
        return pen_.lineTo({pen_.at().x(), from_.y() + data_.number()});
      case 'C':
        return cubic(point());
      case 'S':
        return cubic(last_ == 'C' || last_ == 'S' ? mirrored() : pen_.at());
      case 'Q':
        return quadratic(point());
      case 'T':
        return quadratic(last_ == 'Q' || last_ == 'T' ? mirrored() : pen_.at());
      case 'A':
        return arc();
      case 'Z':
        return pen_.close();
      default:
        data_.refuse();
    }
  }

  Point2 mirrored() const { return 2.0 * pen_.at() - control_; }

  void cubic(const Point2& first) {
    control_ = point();
    pen_.cubicTo(first, control_, point());
  }

  void quadratic(const Point2& control) {
    control_ = control;
    pen_.quadraticTo(control, point());
  }

  /// From its ends, as [SVG2011, appendix F.6] has it.
  void arc() {
    Point2 radii(std::abs(data_.number()), 0.0);
    radii.y() = std::abs(data_.number());
    const double turn_rad = toRadians(data_.number());
    const bool is_large = data_.flag();
    const bool is_sweep = data_.flag();
    const Point2 end = point();
    if (radii.minCoeff() <= 0.0 || end == pen_.at()) return pen_.lineTo(end);
    const Eigen::Rotation2Dd turn(turn_rad);
    const Point2 half = turn.inverse() * (0.5 * (pen_.at() - end));
    const double reach = half.cwiseQuotient(radii).squaredNorm();
    if (reach > 1.0) radii *= std::sqrt(reach);
    const Point2 unit = half.cwiseQuotient(radii);
    const double off =
        std::sqrt(std::max(0.0, 1.0 / unit.squaredNorm() - 1.0)) * (is_large == is_sweep ? -1.0 : 1.0);
    const Point2 centre_unit = off * Point2(unit.y(), -unit.x());
    const Point2 begin_at = unit - centre_unit;
    const Point2 end_at = -unit - centre_unit;
    const double begin_rad = std::atan2(begin_at.y(), begin_at.x());
    double sweep_rad = std::atan2(end_at.y(), end_at.x()) - begin_rad;
    if (is_sweep && sweep_rad < 0.0) sweep_rad += 2.0 * M_PI;
    if (!is_sweep && sweep_rad > 0.0) sweep_rad -= 2.0 * M_PI;
    SvgEllipse ellipse;
    ellipse.centre = turn * centre_unit.cwiseProduct(radii) + 0.5 * (pen_.at() + end);
    ellipse.radii = radii;
    ellipse.turn_rad = turn_rad;
    pen_.ellipticTo(ellipse, begin_rad, begin_rad + sweep_rad);
    pen_.lineTo(end);
  }

  PathData& data_;
  SvgPen& pen_;
  Point2 from_ = Point2::Zero();
  Point2 control_ = Point2::Zero();
  char last_ = 0;
};

/// What numbers without a command behind one mean.
char repeated(char letter) {
  if (letter == 'M') return 'L';
  return letter == 'm' ? 'l' : letter;
}

}  // namespace

void SvgPen::add(const Point2& point) {
  const Point2 mapped = map_ * point;
  if (outline_.empty() || outline_.back() != mapped) outline_.push_back(mapped);
}

void SvgPen::moveTo(const Point2& point) {
  close();
  at_ = begin_ = point;
}

void SvgPen::lineTo(const Point2& point) {
  if (outline_.empty()) add(at_);
  add(point);
  at_ = point;
}

void SvgPen::quadraticTo(const Point2& control, const Point2& end) {
  const Point2 begin = at_;
  cubicTo(begin + 2.0 / 3.0 * (control - begin), end + 2.0 / 3.0 * (control - end), end);
}

void SvgPen::cubicTo(const Point2& first, const Point2& second, const Point2& end) {
  const Point2 begin = at_;
  const auto bend = [&](const Point2& a, const Point2& b, const Point2& c) {
    return (map_.linear() * (a - 2.0 * b + c)).norm();
  };
  const int pieces = piecesFor(6.0 * std::max(bend(begin, first, second), bend(first, second, end)));
  for (int i = 1; i < pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const double s = 1.0 - t;
    lineTo(s * s * s * begin + 3.0 * s * s * t * first + 3.0 * s * t * t * second + t * t * t * end);
  }
  lineTo(end);
}

void SvgPen::ellipticTo(const SvgEllipse& ellipse, double begin_rad, double end_rad) {
  const double scale = greatestStretch(map_.linear());
  const double sweep_rad = end_rad - begin_rad;
  const int pieces = std::max(3, piecesFor(scale * ellipse.radii.maxCoeff() * sweep_rad * sweep_rad));
  const Eigen::Rotation2Dd turn(ellipse.turn_rad);
  for (int i = 0; i <= pieces; ++i) {
    const double angle = begin_rad + sweep_rad * i / pieces;
    const Point2 on = ellipse.radii.cwiseProduct(Point2(std::cos(angle), std::sin(angle)));
    lineTo(ellipse.centre + turn * on);
  }
}

void SvgPen::close() {
  if (outline_.size() > 1 && outline_.front() == outline_.back()) outline_.pop_back();
  if (outline_.size() > 2) outlines_.push_back(std::move(outline_));
  outline_.clear();
  at_ = begin_;
}

std::vector<Polygon> SvgPen::finish() && {
  close();
  return std::move(outlines_);
}

std::optional<std::vector<Polygon>> svgPath(std::string_view text, const Eigen::Affine2d& mm_from_user) {
  PathData data(text);
  SvgPen pen(mm_from_user);
  PathRunner runner(data, pen);
  std::optional<char> letter;
  while (!data.isAtEnd()) {
    const std::optional<char> next = data.command();
    const bool is_first = !letter;
    if (!next && (is_first || *letter == 'Z' || *letter == 'z')) return std::nullopt;
    if (next && is_first && *next != 'M' && *next != 'm') return std::nullopt;
    letter = next ? *next : repeated(*letter);
    runner.run(*letter);
    if (data.isBroken()) return std::nullopt;
  }
  return std::move(pen).finish();
}

}  // namespace lamina
