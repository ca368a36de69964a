// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "infill/contour/normal_loop.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"

namespace lamina {
namespace {

constexpr double kSpacing = 1.5;
constexpr double kOnFacet = 1e-6;

bool isOnFacet(const Point3& point, const Point3& a, const Point3& b, const Point3& c) {
  const Point3 normal = (b - a).cross(c - a).normalized();
  if (std::abs((point - a).dot(normal)) > kOnFacet) return false;
  const auto isLeftOf = [&](const Point3& from, const Point3& to) {
    return (to - from).normalized().cross(point - from).dot(normal) > -kOnFacet;
  };
  return isLeftOf(a, b) && isLeftOf(b, c) && isLeftOf(c, a);
}

bool isOnMesh(const Mesh& mesh, const Point3& point) {
  for (const Triangle& t : mesh.triangles)
    if (isOnFacet(point, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]])) return true;
  return false;
}

std::size_t pointsNeeded(const Polygon& contour) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const double edge = (contour[(i + 1) % contour.size()] - contour[i]).norm();
    if (edge >= 1e-9) count += 1 + static_cast<std::size_t>(std::ceil(edge / kSpacing)) - 1;
  }
  return count;
}

/// Perimeters of sliced parts [Flores2018, figures 38 to 41].
class PerimeterPoints : public testing::TestWithParam<std::string> {
 protected:
  PerimeterPoints() : mesh_(makePart(GetParam())) {
    NoProgress progress;
    const double top = boundingBox(mesh_).high.z();
    for (int k = 0; k < 8; ++k) heights_.push_back(top * (0.06 + 0.117 * k));
    sections_ = sliceMesh(mesh_, heights_, progress);
  }

  Mesh mesh_;
  std::vector<double> heights_;
  std::vector<Section> sections_;
};

TEST_P(PerimeterPoints, LieOnFacets) {
  for (std::size_t k = 0; k < sections_.size(); ++k) {
    ASSERT_FALSE(sections_[k].contours.empty());
    for (const Polygon& contour : sections_[k].contours)
      for (const Point2& point : withNormals(contour, kSpacing).points)
        ASSERT_TRUE(isOnMesh(mesh_, {point.x(), point.y(), heights_[k]})) << point.transpose();
  }
}

TEST_P(PerimeterPoints, AreAsManyAsTheSpacingNeeds) {
  for (const Section& section : sections_)
    for (const Polygon& contour : section.contours)
      EXPECT_EQ(withNormals(contour, kSpacing).points.size(), pointsNeeded(contour));
}

TEST_P(PerimeterPoints, AreNeitherFartherApartThanTheSpacingNorTheSame) {
  for (const Section& section : sections_)
    for (const Polygon& contour : section.contours) {
      const Polygon points = withNormals(contour, kSpacing).points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double step = (points[(i + 1) % points.size()] - points[i]).norm();
        EXPECT_LE(step, kSpacing + 1e-9);
        EXPECT_GE(step, 1e-9);
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, PerimeterPoints, testing::Values("sphere", "cylinder", "box"),
                         [](const testing::TestParamInfo<std::string>& part) { return part.param; });

}  // namespace
}  // namespace lamina
