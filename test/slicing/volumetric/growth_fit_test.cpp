// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/growth_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "support/grown_parts.hpp"
#include "support/lofted_solid.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr GrowthLimits kFitLimits{0.5, 2.0, 1.7};

struct Fitted {
  CellGraph cells;
  ArrivalField arrival;
  ArrivalField field;
};

Fitted fitted(const Mesh& mesh, double cell_mm, GrowthTarget target, double skin_slope_deg = 25.0) {
  NoProgress progress;
  CellGraph cells(mesh, cell_mm, 0.0, progress);
  const GrowthGauge gauge(kFitLimits);
  ArrivalField arrival = arrivalField(cells, gauge, {0.0, 0.1}, progress);
  ArrivalField field = fittedGrowth(mesh, {cells, arrival, gauge},
                                    {target, kFitLimits, toRadians(skin_slope_deg), 0.2, 8, {}}, progress);
  return {std::move(cells), std::move(arrival), std::move(field)};
}

/// Fitted to a direction at each place.
template <class Direction>
Fitted fittedAlong(const Mesh& mesh, double cell_mm, const Direction& directionAt,
                   GrowthFoot foot = GrowthFoot::Flat, int rounds = 8) {
  NoProgress progress;
  CellGraph cells(mesh, cell_mm, 0.0, progress);
  const GrowthGauge gauge(kFitLimits);
  ArrivalField arrival = arrivalField(cells, gauge, {0.0, 0.1}, progress);
  GrowthFitRequest request{GrowthTarget::Given, kFitLimits, 0.44, 0.2, rounds, {}, foot};
  request.given.reserve(cells.nodeCount());
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node)
    request.given.push_back(directionAt(cells.middle(node)));
  ArrivalField field = fittedGrowth(mesh, {cells, arrival, gauge}, request, progress);
  return {std::move(cells), std::move(arrival), std::move(field)};
}

double angleDeg(const Point3& a, const Point3& b) {
  return toDegrees(std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)));
}

/// Calls visit(place, growth, gradient) at nodes.
template <class Visit>
void visitNodes(const Fitted& part, const Visit& visit) {
  for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node)
    visit(part.cells.middle(node), part.field.growth_mm[node], part.field.fitted_gradient[node]);
}

class Mean {
 public:
  void add(double value) {
    sum_ += value;
    count_ += 1.0;
  }
  double mean() const { return sum_ / count_; }

 private:
  double sum_ = 0.0;
  double count_ = 0.0;
};

TEST(GrowthFit, LeavesLevelGrowthAsItIs) {
  for (const GrowthTarget target : {GrowthTarget::Smooth, GrowthTarget::Surface, GrowthTarget::Tangent}) {
    const Fitted part = fitted(test::boxBetween({0, 0, 0}, {10.3, 8, 12}), 0.7, target);
    SCOPED_TRACE(static_cast<int>(target));
    visitNodes(part, [](const Point3& place, double growth, const Point3& gradient) {
      EXPECT_NEAR(growth, place.z(), 1e-9);
      EXPECT_LT((gradient - Point3::UnitZ()).norm(), 1e-5)
          << place.transpose() << " g " << gradient.transpose();
    });
    EXPECT_EQ(std::count(part.field.is_level.begin(), part.field.is_level.end(), 0), 0);
  }
}

// A quarter of a torus, R = 30 mm and r = 10 mm, that stands on one end. About the axis of the bend growth is
// proportional to the angle, and the length of its gradient to 1 / distance.
TEST(GrowthFit, CrossesABentTubeByPlanesThroughTheAxisOfItsBend) {
  const Mesh tube = makePart("elbow", {{"radius_mm", "10"}, {"bend_radius_mm", "30"}, {"foot_mm", "0.001"}});
  const Fitted part = fitted(tube, 1.0, GrowthTarget::Tangent);
  double error_deg = 0.0;
  double slope_mm = 0.0;
  double nodes = 0.0;
  Mean inner;
  Mean outer;
  for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node) {
    if (part.cells.links(node).size() < 26) continue;  // half a cell of error at the skin
    const Point3& place = part.cells.middle(node);
    const Point3& gradient = part.field.fitted_gradient[node];
    const Point3 from_axis = place - Point3(30.0, place.y(), 0.0);
    const double angle = std::atan2(place.z(), 30.0 - place.x());
    if (angle < toRadians(15.0) || angle > toRadians(75.0)) continue;
    const Point3 tangent = Point3::UnitY().cross(from_axis).normalized();
    error_deg += toDegrees(std::acos(std::min(1.0, gradient.normalized().dot(tangent))));
    slope_mm += gradient.norm() * from_axis.norm();
    nodes += 1.0;
    if (std::abs(from_axis.norm() - 22.0) < 1.0) inner.add(gradient.norm());
    if (std::abs(from_axis.norm() - 38.0) < 1.0) outer.add(gradient.norm());
  }
  EXPECT_LT(error_deg / nodes, 1.0);
  EXPECT_NEAR(outer.mean() / inner.mean(), 22.0 / 38.0, 0.02);
  // The innermost layers are as thin as they may be, but for 0.5 % of the volume.
  EXPECT_NEAR(slope_mm / nodes, 20.5, 0.5);
}

/// Mean angle between growth and the tangents of a bend of 30 mm about the axis x = 30 mm, z = 0, at nodes
/// within the part whose angle about it is within a range.
double meanTurnFromTangents(const Fitted& part, double from_deg, double to_deg) {
  Mean error_deg;
  for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node) {
    const Point3& place = part.cells.middle(node);
    const double angle_deg = toDegrees(std::atan2(place.z(), 30.0 - place.x()));
    if (part.cells.links(node).size() < 26 || angle_deg < from_deg || angle_deg > to_deg) continue;
    const Point3 tangent = Point3::UnitY().cross(place - Point3(30.0, place.y(), 0.0)).normalized();
    const double cosine = part.field.fitted_gradient[node].normalized().dot(tangent);
    error_deg.add(toDegrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
  }
  return error_deg.mean();
}

// A gradient cannot be as long inside a bend as outside: asked to be, it leaned by up to 13 deg at the end.
TEST(GrowthFit, CrossesABentTubeAsWellAtItsEnd) {
  for (const char* const angle_deg : {"65", "90"}) {
    SCOPED_TRACE(angle_deg);
    const Mesh tube = makePart(
        "elbow",
        {{"radius_mm", "10"}, {"bend_radius_mm", "30"}, {"foot_mm", "0.001"}, {"angle_deg", angle_deg}});
    const Fitted part = fitted(tube, 1.0, GrowthTarget::Tangent);
    const double end_deg = std::stod(angle_deg);
    EXPECT_LT(meanTurnFromTangents(part, 2.0, end_deg - 15.0), 1.0);
    EXPECT_LT(meanTurnFromTangents(part, end_deg - 15.0, end_deg - 4.0), 1.0);
    EXPECT_LT(meanTurnFromTangents(part, end_deg - 4.0, end_deg), 1.5);
  }
}

TEST(GrowthFit, LeavesLevelGrowthAsItIsWhereUpIsGiven) {
  const Fitted part = fittedAlong(test::boxBetween({0, 0, 0}, {10.3, 8, 12}), 0.7,
                                  [](const Point3&) { return Point3(Point3::UnitZ()); });
  visitNodes(part, [](const Point3& place, double growth, const Point3& gradient) {
    EXPECT_NEAR(growth, place.z(), 1e-9);
    EXPECT_LT((gradient - Point3::UnitZ()).norm(), 1e-5) << place.transpose();
  });
  EXPECT_EQ(std::count(part.field.is_level.begin(), part.field.is_level.end(), 0), 0);
}

// Over a wedge above the first layer, which stays flat.
TEST(GrowthFit, LiesAcrossOneGivenDirection) {
  const Point3 tilted(std::sin(toRadians(20.0)), 0.0, std::cos(toRadians(20.0)));
  const Fitted part = fittedAlong(test::boxBetween({0, 0, 0}, {10, 10, 36}), 1.0,
                                  [&](const Point3&) { return Point3(tilted); });
  Mean off_deg;
  Mean first_deg;
  visitNodes(part, [&](const Point3& place, double, const Point3& gradient) {
    if (place.z() > 16.0) {
      EXPECT_LT(angleDeg(gradient, tilted), 1.0) << place.transpose();
      off_deg.add(angleDeg(gradient, tilted));
    }
    if (place.z() < 1.0) first_deg.add(angleDeg(gradient, tilted));
  });
  EXPECT_LT(off_deg.mean(), 0.2);
  EXPECT_GT(first_deg.mean(), 3.0);
}

// A cylinder that leans by 45 deg on its elliptic foot: plane layers across its axis from the first one on,
// of equal thickness. Growth begins at the rim of the foot, at x = -10 mm.
TEST(GrowthFit, CrossesALeaningCylinderFromItsFootOnIfTheFootIsFree) {
  Mesh cylinder = makePart("cylinder", {{"radius_mm", "10"}, {"height_mm", "14"}, {"segments", "256"}});
  for (Point3& vertex : cylinder.vertices) vertex.x() += vertex.z();
  Point3 axis = Point3(1.0, 0.0, 1.0).normalized();
  const auto along = [&](const Point3&) { return axis; };
  const Fitted part = fittedAlong(cylinder, 1.0, along, GrowthFoot::Free);
  Mean is_off;  // at crumbs of a cell without neighbours all around
  visitNodes(part, [&](const Point3& place, double growth, const Point3& gradient) {
    is_off.add(angleDeg(gradient, axis) > 0.2 || std::abs(gradient.norm() - 1.0) > 0.002 ? 1.0 : 0.0);
    EXPECT_NEAR(growth, axis.dot(place + Point3(10.0, 0.0, 0.0)), 0.4) << place.transpose();  // bits of 0.25
  });
  EXPECT_LT(is_off.mean(), 0.01);
  Mean bound_deg;
  visitNodes(fittedAlong(cylinder, 1.0, along), [&](const Point3& place, double, const Point3& gradient) {
    if (place.z() < 1.0 && place.x() < 8.0) bound_deg.add(angleDeg(gradient, axis));
  });
  EXPECT_GT(bound_deg.mean(), 5.0) << "a flat first layer";
}

TEST(GrowthFit, BeginsAtTheBedInEachBodyIfTheFootIsFree) {
  Mesh boxes = test::boxBetween({0, 0, 0}, {6, 6, 8});
  const Mesh other = test::boxBetween({12, 0, 0}, {18, 6, 5});
  const auto count = static_cast<std::uint32_t>(boxes.vertices.size());
  boxes.vertices.insert(boxes.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& corner : other.triangles)
    boxes.triangles.push_back({corner[0] + count, corner[1] + count, corner[2] + count});
  const Fitted part = fittedAlong(
      boxes, 1.0, [](const Point3&) { return Point3(Point3::UnitZ()); }, GrowthFoot::Free);
  visitNodes(part, [](const Point3& place, double growth, const Point3&) {
    EXPECT_NEAR(growth, place.z(), 1e-3) << place.transpose();
  });
}

// Layers that use up an overhang of 25 deg on a wall that leans by 50 deg, about the apex of its cone, 10 mm
// below the bed: with R and phi polar there, growth R cos²(phi / 2) = (R + z) / 2 tilts by phi / 2 and is
// 1 / cos(phi / 2) as thick. Directions alone leave open how thick layers are one after the other, so that
// the fit is a function of this growth.
TEST(GrowthFit, ReturnsTheGrowthOfAConeThatUsesUpItsOverhang) {
  const double slope = std::tan(toRadians(50.0));
  const Mesh frustum =
      test::loftedSolid({0.0, 10.0}, 128, [&](double, double z) { return slope * (z + 10.0); });
  const Point3 apex(0.0, 0.0, -10.0);
  const auto gradientAt = [&](const Point3& place) {
    return Point3(0.5 * ((place - apex).normalized() + Point3::UnitZ()));
  };
  const Fitted part = fittedAlong(
      frustum, 1.0, [&](const Point3& place) { return Point3(gradientAt(place).normalized()); },
      GrowthFoot::Free, 16);
  Mean off_deg;
  Mean at_axis;  // steepness over the true one, in one growth
  Mean at_wall;
  std::vector<double> truth;
  std::vector<double> fit;
  visitNodes(part, [&](const Point3& place, double growth, const Point3& gradient) {
    off_deg.add(angleDeg(gradient, gradientAt(place)));
    truth.push_back(0.5 * ((place - apex).norm() + place.z() + 10.0));
    fit.push_back(growth);
    if (std::abs(truth.back() - 17.0) > 1.0) return;
    const double lean_deg = angleDeg(place - apex, Point3::UnitZ());
    if (lean_deg < 12.0) at_axis.add(gradient.norm() / gradientAt(place).norm());
    if (lean_deg > 42.0) at_wall.add(gradient.norm() / gradientAt(place).norm());
  });
  EXPECT_LT(off_deg.mean(), 0.5);
  EXPECT_NEAR(at_wall.mean() / at_axis.mean(), 1.0, 0.03) << "1.10 times as thick at the wall";
  // The function, to the third power.
  const auto count = static_cast<Eigen::Index>(truth.size());
  Eigen::MatrixX4d powers(count, 4);
  Eigen::VectorXd values(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double from_middle = (truth[static_cast<std::size_t>(i)] - 15.0) / 10.0;
    powers.row(i) << 1.0, from_middle, from_middle * from_middle, std::pow(from_middle, 3);
    values[i] = fit[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd miss = powers * powers.colPivHouseholderQr().solve(values) - values;
  EXPECT_LT(std::sqrt(miss.squaredNorm() / static_cast<double>(count)), 0.1) << "a tenth of a cell";
}

// The lengths that make a gradient of the tangents of a bend, 1 / distance from its axis, are found by
// rounds.
TEST(GrowthFit, LiesAcrossTheGivenTangentsOfABend) {
  const Mesh tube = makePart(
      "elbow", {{"radius_mm", "10"}, {"bend_radius_mm", "30"}, {"foot_mm", "0.001"}, {"angle_deg", "90"}});
  const Fitted part = fittedAlong(tube, 1.0, [](const Point3& place) {
    return Point3(Point3::UnitY().cross(place - Point3(30.0, place.y(), 0.0)).normalized());
  });
  EXPECT_LT(meanTurnFromTangents(part, 4.0, 75.0), 0.5);
  EXPECT_LT(meanTurnFromTangents(part, 75.0, 90.0), 2.0);
  Mean inner;
  Mean outer;
  visitNodes(part, [&](const Point3& place, double, const Point3& gradient) {
    const double angle_deg = toDegrees(std::atan2(place.z(), 30.0 - place.x()));
    const double from_axis_mm = std::hypot(30.0 - place.x(), place.z());
    if (angle_deg < 20.0 || angle_deg > 70.0) return;
    if (std::abs(from_axis_mm - 22.0) < 1.0) inner.add(gradient.norm());
    if (std::abs(from_axis_mm - 38.0) < 1.0) outer.add(gradient.norm());
  });
  EXPECT_NEAR(outer.mean() / inner.mean(), 22.0 / 38.0, 0.03);
}

// The sides of a slender rod are far larger than its end.
TEST(GrowthFit, EndsASlenderRodAtItsEnd) {
  const Fitted part = fitted(test::boxBetween({0, 0, 0}, {3, 3, 60}), 0.75, GrowthTarget::Tangent);
  visitNodes(part, [](const Point3& place, double growth, const Point3& gradient) {
    EXPECT_NEAR(growth, place.z(), 1e-9);
    EXPECT_LT((gradient - Point3::UnitZ()).norm(), 1e-5) << place.transpose();
  });
}

// Growth along an upright rod whose end is half a sphere is level below it.
TEST(GrowthFit, EndsARodAtItsDome) {
  std::vector<double> heights = {0.0};
  for (int i = 0; i < 12; ++i) heights.push_back(20.0 + 5.0 * std::sin(M_PI_2 * i / 12.0));
  const Mesh rod = test::loftedSolid(heights, 48, [](double, double z) {
    const double above = std::max(0.0, z - 20.0);
    return std::sqrt(25.0 - above * above);
  });
  const Fitted part = fitted(rod, 0.75, GrowthTarget::Tangent);
  Mean tilt_deg;
  visitNodes(part, [&](const Point3& place, double, const Point3& gradient) {
    if (place.z() < 12.0) tilt_deg.add(toDegrees(std::acos(std::min(1.0, gradient.normalized().z()))));
  });
  EXPECT_LT(tilt_deg.mean(), 1.0);
}

TEST(GrowthFit, SaysThatAConeHasNoEnd) {
  const Mesh cone = makePart("cone", {{"radius_mm", "6"}, {"height_mm", "30"}});
  EXPECT_THROW(fitted(cone, 0.75, GrowthTarget::Tangent), Unsliceable);
}

// A block whose top is a cylinder of 60 mm about y: it slopes by up to 14.5 deg.
TEST(GrowthFit, FollowsAVaultedSkin) {
  Region profile;
  profile.outer = {{-15, 0}, {15, 0}};
  for (int i = 0; i <= 30; ++i) {
    const double x = 15.0 - i;
    profile.outer.push_back({x, 10.0 + std::sqrt(60.0 * 60.0 - x * x) - 60.0});
  }
  const Mesh block = test::lyingPrism(profile, 10.0);
  const auto meanSlip = [&](const Fitted& part) {
    double sum = 0.0;
    double nodes = 0.0;
    visitNodes(part, [&](const Point3& place, double, const Point3& gradient) {
      const Point3 normal = Point3(place.x(), 0.0, place.z() + 50.0);
      if (normal.norm() < 59.6 || std::abs(place.x()) < 6.0 || std::abs(place.x()) > 12.0) return;
      sum += toDegrees(std::acos(std::min(1.0, gradient.normalized().dot(normal.normalized()))));
      nodes += 1.0;
    });
    return sum / nodes;
  };
  EXPECT_NEAR(meanSlip(fitted(block, 0.5, GrowthTarget::Smooth)), 8.6, 0.2);
  EXPECT_LT(meanSlip(fitted(block, 0.5, GrowthTarget::Surface)), 2.0);
  // Too steep to be followed but at the crown.
  EXPECT_GT(meanSlip(fitted(block, 0.5, GrowthTarget::Surface, 3.0)), 6.0);
}

TEST(GrowthFit, SmoothsTheBendsOfAT) {
  const Fitted part = fitted(test::tShape(), 0.5, GrowthTarget::Smooth);
  const auto roughness = [&](const auto& gradientOf) {
    double sum = 0.0;
    for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node)
      for (const std::uint32_t near : part.cells.links(node))
        sum += (gradientOf(node) - gradientOf(near)).squaredNorm();
    return sum;
  };
  const GrowthGauge gauge(kFitLimits);
  const double arrived = roughness([&](std::uint32_t node) {
    const Point3& middle = part.cells.middle(node);
    return part.arrival.near(middle, node, middle, gauge).gradient;
  });
  const double smooth = roughness([&](std::uint32_t node) { return part.field.fitted_gradient[node]; });
  EXPECT_LT(smooth, 0.75 * arrived);
}

TEST(GrowthFit, BlendsFromTheArrivalToTheFit) {
  const Fitted part = fitted(test::tShape(), 1.0, GrowthTarget::Smooth);
  const GrowthGauge gauge(kFitLimits);
  const ArrivedGrowth arrived{part.cells, part.arrival, gauge};
  const ArrivalField none = blendedGrowth(arrived, part.field, 0.0);
  const ArrivalField half = blendedGrowth(arrived, part.field, 0.5);
  const ArrivalField all = blendedGrowth(arrived, part.field, 1.0);
  for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node) {
    EXPECT_NEAR(none.growth_mm[node], part.arrival.growth_mm[node], 1e-12);
    EXPECT_NEAR(half.growth_mm[node], 0.5 * (part.arrival.growth_mm[node] + part.field.growth_mm[node]),
                1e-12);
    EXPECT_EQ(all.growth_mm[node], part.field.growth_mm[node]);
  }
}

}  // namespace
}  // namespace lamina
