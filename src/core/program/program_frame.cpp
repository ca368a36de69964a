// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/program_frame.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/base/text_search.hpp"

namespace lamina {
namespace {

constexpr double kSame = 1e-9;         // rad: what rounding leaves of a rotation
constexpr double kUnit = 1e-6;         // of the norm of a quaternion
constexpr double kLeastVolume = 1e-3;  // of the box that three axes of length 1 span
constexpr std::string_view kLayers = "LAYER_FRAME:";
constexpr std::string_view kNozzle = "NOZZLE_FRAME:";
constexpr std::string_view kAxes = "BED_FROM_AXES:";

std::string number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, " %.17g", value);
  return digits;
}

std::string text(const Eigen::Quaterniond& q) {
  return number(q.w()) + number(q.x()) + number(q.y()) + number(q.z());
}

std::string text(const Eigen::Affine3d& map) {
  std::string rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) rows += number(map(row, column));
  return rows;
}

[[noreturn]] void refuse(std::string_view comment, const std::string& what) {
  throw InvalidProgram("comment ';" + std::string(comment) + "': " + what);
}

template <std::size_t count>
std::array<double, count> numbersBehind(std::string_view key, std::string_view comment) {
  std::array<double, count> numbers{};
  std::string_view rest = comment.substr(key.size());
  for (double& value : numbers) {
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    const auto result = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (result.ec != std::errc{} || !std::isfinite(value))
      refuse(comment, "expected " + std::to_string(count) + " numbers");
    rest.remove_prefix(static_cast<std::size_t>(result.ptr - rest.data()));
  }
  return numbers;
}

Eigen::Quaterniond rotationBehind(std::string_view key, std::string_view comment) {
  const auto n = numbersBehind<4>(key, comment);
  const Eigen::Quaterniond rotation(n[0], n[1], n[2], n[3]);
  if (!(std::abs(rotation.norm() - 1.0) < kUnit))
    refuse(comment, "the norm is " + number(rotation.norm()) + "; must be 1");
  return rotation.normalized();
}

Eigen::Affine3d mapBehind(std::string_view key, std::string_view comment) {
  const auto n = numbersBehind<12>(key, comment);
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  for (std::size_t i = 0; i < n.size(); ++i) map(static_cast<int>(i / 4), static_cast<int>(i % 4)) = n[i];
  if (!(std::abs(map.linear().determinant()) > kLeastVolume))
    refuse(comment, "the axes span " + number(map.linear().determinant()) + "; must be more than 0.001");
  return map;
}

bool isSame(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.angularDistance(b) < kSame; }

bool isIdentity(const Eigen::Affine3d& map) { return map.matrix() == Eigen::Matrix4d::Identity(); }

}  // namespace

std::string frameComments(const StatedFrame& frame) {
  const auto line = [](std::string_view key, const std::string& values) {
    return ";" + std::string(key) + values + "\n";
  };
  std::string lines;
  if (!isSame(frame.bed_from_layers, Eigen::Quaterniond::Identity()))
    lines += line(kLayers, text(frame.bed_from_layers));
  if (!isSame(frame.bed_from_nozzle, nozzleDown())) lines += line(kNozzle, text(frame.bed_from_nozzle));
  if (!isIdentity(frame.bed_from_program)) lines += line(kAxes, text(frame.bed_from_program));
  return lines;
}

bool isFrameComment(std::string_view comment) {
  return startsWith(comment, kLayers) || startsWith(comment, kNozzle) || startsWith(comment, kAxes);
}

bool readFrameComment(std::string_view comment, StatedFrame& frame) {
  if (startsWith(comment, kLayers))
    frame.bed_from_layers = rotationBehind(kLayers, comment);
  else if (startsWith(comment, kNozzle))
    frame.bed_from_nozzle = rotationBehind(kNozzle, comment);
  else if (startsWith(comment, kAxes))
    frame.bed_from_program = mapBehind(kAxes, comment);
  else
    return false;
  return true;
}

}  // namespace lamina
