// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/any_machine.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

namespace lamina {
namespace {

constexpr double kLeastAxis = 0.1;  // of a box of half side 1, before the direction is made a unit

Point3 anyPoint(Random& random, double most) {
  return {random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
}

Point3 anyDirection(Random& random) {
  Point3 direction = Point3::Zero();
  while (direction.norm() < kLeastAxis) direction = anyPoint(random, 1.0);
  return direction.normalized();
}

std::string text(const Point3& point) {
  char digits[96];
  std::snprintf(digits, sizeof digits, "%.16g %.16g %.16g", point.x(), point.y(), point.z());
  return digits;
}

std::string linkName(std::size_t index, std::size_t count) {
  if (index == 0) return "bed";
  return index == count ? "nozzle" : "link_" + std::to_string(index);
}

std::string jointText(const MachinePart& part, const std::string& parent, const std::string& child) {
  const bool is_linear = part.name >= "x";
  return "<link name=\"" + child + "\"/><joint name=\"" + part.name + "\" type=\"" +
         (is_linear ? "prismatic" : "revolute") + "\"><parent link=\"" + parent + "\"/><child link=\"" +
         child + "\"/><origin xyz=\"" + text(part.place_m) + "\" rpy=\"" + text(part.rpy) +
         "\"/><axis xyz=\"" + text(part.axis) +
         "\"/><limit lower=\"-3\" upper=\"3\" velocity=\"1\" effort=\"1\"/></joint>";
}

}  // namespace

MachineParts anyParts(Random& random) {
  MachineParts parts;
  for (const char* name : {"x", "y", "z", "a", "b"})
    parts.push_back({name, anyDirection(random), anyPoint(random, 0.3), anyPoint(random, 3.0)});
  return parts;
}

std::string urdfOf(const MachineParts& parts, std::size_t carrying_bed) {
  const std::size_t count = parts.size();
  std::string urdf = "<robot name=\"any\"><link name=\"" + linkName(carrying_bed, count) + "\"/>";
  for (std::size_t j = carrying_bed; j-- > 0;)
    urdf += jointText(parts[j], linkName(j + 1, count), linkName(j, count));
  for (std::size_t j = carrying_bed; j < count; ++j)
    urdf += jointText(parts[j], linkName(j, count), linkName(j + 1, count));
  return urdf + "</robot>";
}

std::string anyMachine(Random& random) {
  MachineParts parts = anyParts(random);
  for (std::size_t j = parts.size(); j-- > 1;) std::swap(parts[j], parts[random.below(j + 1)]);
  return urdfOf(parts, random.below(parts.size() + 1));
}

}  // namespace lamina
