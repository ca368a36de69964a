// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/standing.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

const BedPlane kFarBed{Point3(0, M_SQRT1_2, M_SQRT1_2), -1000.0};
const BedPlane kLevelBed{Point3::UnitZ(), -1000.0};

/// A run across each outline; the last so many outlines of a layer get none.
ToolpathLayer laid(const Layer& layer, std::size_t left_out) {
  ToolpathLayer result;
  result.z_mm = layer.bounds.top_mm;
  const std::vector<Polygon>& outlines = layer.section.contours;
  result.paths.reserve(2 * outlines.size());
  for (std::size_t i = 0; i + left_out < outlines.size(); ++i) {
    const Point2 middle = 0.5 * (outlines[i][0] + outlines[i][2]);
    Path path;
    path.role = PathRole::OuterWall;
    path.points = {Point3(middle.x() - 0.05, middle.y(), layer.bounds.top_mm),
                   Point3(middle.x() + 0.05, middle.y(), layer.bounds.top_mm)};
    Path way;
    way.role = PathRole::Travel;
    way.points = {path.points.front(), path.points.front()};
    result.paths.push_back(std::move(way));
    result.paths.push_back(std::move(path));
  }
  return result;
}

/// Layers of 0.2 mm, of these outlines.
class Floating {
 public:
  explicit Floating(const std::vector<std::vector<Polygon>>& outlines) {
    layers_.reserve(outlines.size());
    for (std::size_t i = 0; i < outlines.size(); ++i)
      layers_.push_back({{0.2 * double(i), 0.2 * double(i + 1)}, {outlines[i], {}}});
  }
  Floating& over(const BedPlane& bed) {
    bed_ = bed;
    return *this;
  }
  Floating& on(std::vector<Regions> supports) {
    supports_ = std::move(supports);
    return *this;
  }
  /// The last so many outlines of the second layer get no bead.
  Floating& without(std::size_t count) {
    left_out_ = count;
    return *this;
  }
  template <class Use>
  auto use(const Use& use) const {
    std::vector<ToolpathLayer> toolpath;
    toolpath.reserve(layers_.size());
    for (std::size_t i = 0; i < layers_.size(); ++i)
      toolpath.push_back(laid(layers_[i], i == 1 ? left_out_ : 0));
    const CarriedLayers carried{layers_, supports_, bed_, 0.4};
    const StartsInAir starts = startsInAir(carried, toolpath);
    return use(PlannedStack{carried, toolpath, starts});
  }
  FloatingIslands found() const {
    return use([](const PlannedStack& stack) { return floatingIslands(stack); });
  }

 private:
  std::vector<Layer> layers_;
  std::vector<Regions> supports_;
  BedPlane bed_ = kFarBed;
  std::size_t left_out_ = 0;
};

const Polygon kFoot = rectangle(0, 0, 10, 10);

/// The first layer floats too, over a bed far below, and is not of interest.
std::size_t islandsAbove(const Floating& part) { return part.found().count - 1; }

TEST(Standing, FindsIslandsThatNothingCarries) {
  const Polygon apart = rectangle(12, 4, 14, 6);
  const FloatingIslands found = Floating({{kFoot}, {kFoot, apart}, {kFoot, apart}}).found();
  EXPECT_EQ(found.count, 2U) << "the foot, and the island once";
  EXPECT_EQ(found.first_layer, 0U);
  EXPECT_NEAR((found.first_mm - Point3(4.95, 5.0, 0.2)).norm(), 0.0, 1e-9);
}

TEST(Standing, CountsAnIslandWithinABeadOfTheLayerBeforeAsCarried) {
  EXPECT_EQ(islandsAbove(Floating({{kFoot}, {kFoot, rectangle(10.39, 4, 12, 6)}})), 0U);
  EXPECT_EQ(islandsAbove(Floating({{kFoot}, {kFoot, rectangle(10.41, 4, 12, 6)}})), 1U);
}

TEST(Standing, TakesSupportsAndTheBedForWhatCarries) {
  const Polygon apart = rectangle(12, 4, 14, 6);
  const Regions column = {{rectangle(11, 3, 15, 7), {}}};
  EXPECT_EQ(islandsAbove(Floating({{kFoot}, {kFoot, apart}}).on({{}, column})), 0U);
  // At 45 deg the plane of the second layer meets a bed of level 0 at y = -0.4.
  const BedPlane bed{kFarBed.up, 0.0};
  EXPECT_EQ(Floating({{kFoot}, {kFoot, rectangle(12, 0, 14, 6)}}).over(bed).found().count, 0U);
  EXPECT_EQ(Floating({{kFoot}, {kFoot, apart}}).over(bed).found().count, 1U);
}

TEST(Standing, LetsNothingLieOnAnIslandWithoutBeads) {
  const Polygon sliver = rectangle(12.0, 4, 12.2, 6);
  const Polygon apart = rectangle(12, 4, 14, 6);
  const Floating part({{kFoot}, {kFoot, sliver}, {kFoot, apart}});
  EXPECT_EQ(islandsAbove(part), 1U);
  EXPECT_EQ(islandsAbove(Floating(part).without(1)), 1U) << "that above it, in its stead";
  EXPECT_EQ(islandsAbove(Floating({{kFoot}, {kFoot, sliver}, {kFoot}}).without(1)), 0U);
}

TEST(Standing, LetsASupportCarryWhatLiesOnABareIsland) {
  const Polygon sliver = rectangle(12.0, 4, 12.2, 6);
  const Regions column = {{rectangle(11.9, 3, 12.3, 7), {}}};
  const Floating part({{kFoot}, {kFoot, sliver}, {kFoot, rectangle(12, 4, 14, 6)}});
  EXPECT_EQ(islandsAbove(Floating(part).without(1).on({{}, column, {}})), 0U);
}

TEST(Standing, LeavesLevelLayersToSupports) {
  EXPECT_EQ(Floating({{kFoot}, {kFoot, rectangle(12, 4, 14, 6)}}).over(kLevelBed).found().count, 0U);
}

TEST(Standing, NamesTheFirstIslandInTheFrameOfThePart) {
  const BedPlane bed{kFarBed.up, 0.0};
  const Polygon foot = rectangle(0, -5, 10, 5);  // its run lies in the bed
  const Floating part = Floating({{foot}, {foot, rectangle(12, 4, 14, 6)}}).over(bed);
  const Eigen::Isometry3d moved(Eigen::Translation3d(100.0, 0.0, 0.0));
  part.use([&](const PlannedStack& stack) {
    try {
      requireStanding(stack, moved);
      ADD_FAILURE() << "nothing is refused";
    } catch (const InvalidInput& error) {
      const std::string refusal = error.what();
      EXPECT_EQ(refusal.rfind("islands of layers that begin in mid-air: 1, the first in layer 1 at "
                              "(112.95, 5.00, 0.40) mm of the part; expected",
                              0),
                0U)
          << refusal;
      EXPECT_NE(refusal.find("supports.use true"), std::string::npos) << refusal;
      EXPECT_NE(refusal.find("'where_possible'"), std::string::npos) << refusal;
    }
    return 0;
  });
}

}  // namespace
}  // namespace lamina
