// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using Change = std::function<void(Toolpath&)>;

Path& wallOf(Toolpath& toolpath) { return toolpath.layers[0].paths[0]; }

/// Every value a toolpath holds, changed a little.
std::vector<Change> everyChange() {
  return {
      [](Toolpath& t) { t.part_name = "squarf"; },
      [](Toolpath& t) { t.layers[0].z_mm += 1e-12; },
      [](Toolpath& t) { t.layers[0].height_mm += 1e-12; },
      [](Toolpath& t) { t.layers.pop_back(); },
      [](Toolpath& t) { t.layers.emplace_back(); },
      [](Toolpath& t) { t.layers[0].paths.pop_back(); },
      [](Toolpath& t) { std::swap(t.layers[0].paths[0], t.layers[0].paths[1]); },
      [](Toolpath& t) { wallOf(t).role = PathRole::InnerWall; },
      [](Toolpath& t) { wallOf(t).is_closed = false; },
      [](Toolpath& t) { wallOf(t).process.is_retracted = true; },
      [](Toolpath& t) { wallOf(t).points[3].z() += 1e-12; },
      [](Toolpath& t) { std::swap(wallOf(t).points[1], wallOf(t).points[2]); },
      [](Toolpath& t) { wallOf(t).points.pop_back(); },
      [](Toolpath& t) { wallOf(t).orientation = Eigen::Quaterniond(0, 0, 1, 0); },
      [](Toolpath& t) {
        wallOf(t).bead = Bead{0.4, 0.2000001};
      },
      [](Toolpath& t) {
        wallOf(t).bead = Bead{0.2, 0.4};
      },
      [](Toolpath& t) { wallOf(t).feed_mm_s = 30.0000001; },
      [](Toolpath& t) {
        wallOf(t).feed_mm_s = AlongPath<double>({30.0, 30.0, 30.0, 30.0});
      },
  };
}

TEST(ToolpathId, ChangesWithEveryValue) {
  std::set<std::string> ids = {toolpathId(test::twoLayers())};
  const std::vector<Change> changes = everyChange();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Toolpath toolpath = test::twoLayers();
    changes[i](toolpath);
    EXPECT_TRUE(ids.insert(toolpathId(toolpath)).second) << "change " << i;
  }
}

TEST(ToolpathId, IsTheSameForTheSameValues) {
  EXPECT_EQ(toolpathId(test::twoLayers()), toolpathId(test::twoLayers()));
}

TEST(ToolpathId, IsSixteenHexadecimalDigits) {
  for (const std::string& id : {toolpathId({}), toolpathId(test::twoLayers())}) {
    EXPECT_EQ(id.size(), 16U);
    EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos);
  }
}

TEST(ToolpathId, ReportsWhereALayerEnds) {
  Toolpath one = test::twoLayers();
  Toolpath other = one;
  // The same paths in the same order, the travel in the other layer.
  other.layers[1].paths.insert(other.layers[1].paths.begin(), other.layers[0].paths.back());
  other.layers[0].paths.pop_back();
  EXPECT_NE(toolpathId(one), toolpathId(other));
}

}  // namespace
}  // namespace lamina
