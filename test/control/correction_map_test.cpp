// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/correction_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

CorrectionMap smallMap() {
  return {
      "0123456789abcdef", 12, 3, {{0, 0.5, {{0.1, 0.0, 0.0}, {0.2, -0.1, 0.05}}}, {4, 1.25, {{-0.3, 0, 0}}}}};
}

TEST(CorrectionMap, IsLinearBetweenStationsAndHoldsAtTheEnds) {
  const PathCorrection path = smallMap().paths[0];
  EXPECT_EQ(correctionAt(path, 0.0).amount, 0.1);
  EXPECT_EQ(correctionAt(path, 0.25).amount, 0.1);
  EXPECT_NEAR(correctionAt(path, 0.5).amount, 0.15, 1e-15);
  EXPECT_NEAR(correctionAt(path, 0.5).dz_mm, 0.025, 1e-15);
  EXPECT_EQ(correctionAt(path, 9.0).amount, 0.2);
  EXPECT_TRUE(correctionAt({}, 1.0).isNone());
}

TEST(CorrectionMap, HoldsWhatEachCellIsToHave) {
  const LayerCells cells = test::straightBeads({0.0, 3.0}, 10.0, 1.0);
  std::vector<double> amount(cells.size(), 0.0);
  amount[12] = 0.4;
  const CorrectionMap map = correctionMap(cells, {amount, {}, {}}, "id", 7);
  ASSERT_EQ(map.paths.size(), 2U);
  EXPECT_EQ(map.paths[1].path, 2U);
  EXPECT_EQ(map.paths[1].spacing_mm, 1.0);
  EXPECT_EQ(correctionAt(map.paths[1], 2.5).amount, 0.4);
}

TEST(CorrectionMap, ReadsBackToTheSameBits) {
  EXPECT_TRUE(rc::check("whatever it holds", [] {
    CorrectionMap map{"00ff00ff00ff00ff",
                      *rc::gen::inRange<std::size_t>(0, 1000),
                      *rc::gen::arbitrary<std::uint32_t>(),
                      {}};
    const int paths = *rc::gen::inRange(0, 4);
    for (int p = 0; p < paths; ++p) {
      PathCorrection path{static_cast<std::size_t>(2 * p), 0.1 + 0.01 * *rc::gen::inRange(0, 1000), {}};
      const int stations = *rc::gen::inRange(1, 5);
      for (int i = 0; i < stations; ++i)
        path.stations.push_back({*rc::gen::inRange(-900, 5000) / 1001.0,
                                 *rc::gen::inRange(-900, 900) / 1003.0,
                                 *rc::gen::inRange(-900, 900) / 997.0});
      map.paths.push_back(path);
    }
    const int expected = *rc::gen::inRange(0, 4);
    if (expected > 0) map.ahead.interval_s = 0.01 * *rc::gen::inRange(1, 900) / 1.07;
    for (int i = 0; i < expected; ++i) map.ahead.amount.push_back(*rc::gen::inRange(-900, 5000) / 1001.0);
    const CorrectionMap read = readCorrectionMap(correctionMapCsv(map), "map");
    RC_ASSERT(digestOf(read) == digestOf(map));
    RC_ASSERT(correctionMapCsv(read) == correctionMapCsv(map));
  }));
}

TEST(CorrectionMap, HasADigestOfEveryValue) {
  const std::string digest = digestOf(smallMap());
  EXPECT_EQ(digest.size(), 16U);
  CorrectionMap other = smallMap();
  other.sequence = 4;
  EXPECT_NE(digestOf(other), digest);
  other = smallMap();
  other.paths[0].stations[1].dz_mm = 0.0500001;
  EXPECT_NE(digestOf(other), digest);
}

TEST(CorrectionMap, SaysWithWhatTheLayerAboveBegins) {
  CorrectionMap map = smallMap();
  map.ahead = {0.05, {0.1, -0.25}};
  EXPECT_NE(digestOf(map), digestOf(smallMap()));
  const std::string text = correctionMapCsv(map);
  EXPECT_NE(text.find("\n# ahead 0.05 0.1 -0.25\n"), std::string::npos) << text;
  const CorrectionMap read = readCorrectionMap(text, "map");
  EXPECT_EQ(read.ahead.interval_s, 0.05);
  EXPECT_EQ(read.ahead.amount, map.ahead.amount);
  const auto with = [&](const std::string& ahead) {
    std::string changed = text;
    const std::string line = "# ahead 0.05 0.1 -0.25";
    return changed.replace(changed.find(line), line.size(), ahead);
  };
  for (const char* ahead : {"# ahead 0.05 0.1 -0.24", "# ahead 0.05 0.1", "# ahead 0.05",
                            "# ahead 0 0.1 -0.25", "# ahead 0.05 0.1 -1", "# ahead 0.05 0.1 nan",
                            "# ahead 0.05 0.1 x", "# ahead inf 0.1 -0.25", "# behind"})
    EXPECT_THROW(readCorrectionMap(with(ahead), "map"), InvalidInput) << ahead;
}

TEST(CorrectionMap, RefusesWhatIsNone) {
  const std::string good = correctionMapCsv(smallMap());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  EXPECT_NO_THROW(readCorrectionMap(good, "map"));
  EXPECT_NO_THROW(readCorrectionMap("# layered by the night shift\n" + good, "map"))
      << "a remark, not the layer";
  EXPECT_THROW(readCorrectionMap(changed("0.2", "0.21"), "map"), InvalidInput) << "digest";
  EXPECT_THROW(readCorrectionMap(changed("0.2", "nan"), "map"), InvalidInput);
  EXPECT_THROW(readCorrectionMap(changed("0.2", "-1.5"), "map"), InvalidInput);
  EXPECT_THROW(readCorrectionMap(changed("0.2", "lots"), "map"), InvalidInput);
  EXPECT_THROW(readCorrectionMap(changed("0,0.5,0.2", "0,0.6,0.2"), "map"), InvalidInput);
  EXPECT_THROW(readCorrectionMap(changed("4,1.25", "4,-1.25"), "map"), InvalidInput);
  EXPECT_THROW(readCorrectionMap(changed("amount", "flow"), "map"), InvalidInput);
  EXPECT_THROW(readCorrectionMap(changed("# layer 12", "# layer"), "map"), InvalidInput);
  EXPECT_THROW(readCorrectionMap(changed("# digest", "# "), "map"), InvalidInput);
  EXPECT_THROW(readCorrectionMap("", "map"), InvalidInput);
  try {
    readCorrectionMap(changed("-0.3", "-3"), "map.csv");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "map.csv: correction of path 4, station 0: the amount changes by -3; expected more "
                 "than -1 and "
                 "at most 5");
  }
}

TEST(CorrectionMap, RefusesWhatNoLoopAsksFor) {
  const auto mapWith = [](const PointCorrection& place) {
    return CorrectionMap{"part", 0, 1, {{0, 1.0, {place}}}};
  };
  EXPECT_NO_THROW(validate(mapWith({5.0, 5.0, -3.0})));
  EXPECT_THROW(validate(mapWith({50.0, 0.0, 0.0})), InvalidInput);
  EXPECT_THROW(validate(mapWith({0.0, 5.1, 0.0})), InvalidInput);
  EXPECT_THROW(validate(mapWith({0.0, 0.0, 101.0})), InvalidInput);
  // By these a layer would be divided into more cells than fit into memory.
  const auto spaced = [](double spacing_mm) {
    return CorrectionMap{"part", 0, 1, {{0, spacing_mm, {{}, {}}}}};
  };
  EXPECT_NO_THROW(validate(spaced(1e-3)));
  EXPECT_THROW(validate(spaced(1e-9)), InvalidInput);
}

}  // namespace
}  // namespace lamina
