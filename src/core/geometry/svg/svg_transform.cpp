// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/svg/svg_transform.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr double kMmPerInch = 25.4;

void skipSeparators(std::string_view& text) {
  while (!text.empty() && (std::isspace(static_cast<unsigned char>(text[0])) != 0 || text[0] == ','))
    text.remove_prefix(1);
}

/// A number at the beginning of the text, which is taken off it.
std::optional<double> takeNumber(std::string_view& text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  return value;
}

/// Column by column.
Eigen::Affine2d affine(const std::array<double, 6>& v) {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  map.linear() << v[0], v[2], v[1], v[3];
  map.translation() << v[4], v[5];
  return map;
}

std::optional<Eigen::Affine2d> rotation(const std::vector<double>& v) {
  if (v.size() != 1 && v.size() != 3) return std::nullopt;
  const Eigen::Vector2d centre = v.size() == 3 ? Eigen::Vector2d(v[1], v[2]) : Eigen::Vector2d(0.0, 0.0);
  return Eigen::Affine2d(Eigen::Translation2d(centre) * Eigen::Rotation2Dd(v[0] * kDegree) *
                         Eigen::Translation2d(-centre));
}

std::optional<Eigen::Affine2d> single(std::string_view name, const std::vector<double>& v) {
  if (name == "matrix" && v.size() == 6) return affine({v[0], v[1], v[2], v[3], v[4], v[5]});
  if (name == "translate" && (v.size() == 1 || v.size() == 2))
    return affine({1.0, 0.0, 0.0, 1.0, v[0], v.size() == 2 ? v[1] : 0.0});
  if (name == "scale" && (v.size() == 1 || v.size() == 2))
    return affine({v[0], 0.0, 0.0, v.size() == 2 ? v[1] : v[0], 0.0, 0.0});
  if (name == "rotate") return rotation(v);
  if (name == "skewX" && v.size() == 1) return affine({1.0, 0.0, std::tan(v[0] * kDegree), 1.0, 0.0, 0.0});
  if (name == "skewY" && v.size() == 1) return affine({1.0, std::tan(v[0] * kDegree), 0.0, 1.0, 0.0, 0.0});
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<double>> svgNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (skipSeparators(text); !text.empty(); skipSeparators(text)) {
    const std::optional<double> number = takeNumber(text);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<Eigen::Affine2d> svgTransform(std::string_view text) {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  for (skipSeparators(text); !text.empty(); skipSeparators(text)) {
    const std::size_t open = text.find('(');
    const std::size_t close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      return std::nullopt;
    const auto numbers = svgNumbers(text.substr(open + 1, close - open - 1));
    const auto next = numbers ? single(trimmed(text.substr(0, open)), *numbers) : std::nullopt;
    if (!next) return std::nullopt;
    map = map * *next;
    text.remove_prefix(close + 1);
  }
  return map;
}

std::optional<double> svgLength(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 7> kUnits = {{{"", kMmPerInch / 96.0},
                                                                          {"px", kMmPerInch / 96.0},
                                                                          {"mm", 1.0},
                                                                          {"cm", 10.0},
                                                                          {"in", kMmPerInch},
                                                                          {"pt", kMmPerInch / 72.0},
                                                                          {"pc", kMmPerInch / 6.0}}};
  text = trimmed(text);
  const std::optional<double> value = takeNumber(text);
  if (!value) return std::nullopt;
  for (const auto& [name, mm] : kUnits)
    if (trimmed(text) == name) return *value * mm;
  return std::nullopt;
}

}  // namespace lamina
