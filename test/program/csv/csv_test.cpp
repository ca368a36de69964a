// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/program/csv/csv_writer.hpp"

namespace lamina {
namespace {

std::string written(const Toolpath& toolpath) {
  std::string text;
  writeCsv(toolpath, [&text](std::string_view piece) { text += piece; });
  return text;
}

ToolpathEvent randomEvent(Random& random) {
  const std::string text = "100%, a|b;\t\xc3\xa9=";
  switch (random.below(6)) {
    case 0:
      return Dwell{random.uniform(0.0, 100.0)};
    case 1:
      return FanShare{random.uniform(0.0, 1.0)};
    case 2:
      return OperatorPause{"100%, a|b"};
    case 3:
      return PartMark{"100%, a|b"};
    case 4:
      return MachineCode{text + "\nM5", false};
    default:
      return MachineCode{text, true};
  }
}

void addProcess(Path& path, Random& random) {
  path.tool = static_cast<std::uint32_t>(random.below(3));
  for (std::size_t m = 0; m <= path.motionCount(); ++m)
    for (std::size_t i = random.below(3); i > 0; --i) path.events.push_back({m, randomEvent(random)});
  std::vector<double> powers;
  for (std::size_t i = 0; i < path.points.size(); ++i) powers.push_back(random.uniform(0.0, 1e3));
  if (random.below(2) == 0) path.values.push_back({"power_w", AlongPath<double>(powers)});
  if (random.below(2) == 0) path.values.push_back({"wire_mm_s", powers[0]});
}

bool isSameEvent(const Dwell& a, const Dwell& b) { return a.duration_s == b.duration_s; }
bool isSameEvent(const FanShare& a, const FanShare& b) { return a.share == b.share; }
bool isSameEvent(const OperatorPause& a, const OperatorPause& b) { return a.message == b.message; }
bool isSameEvent(const PartMark& a, const PartMark& b) { return a.name == b.name; }
bool isSameEvent(const MachineCode& a, const MachineCode& b) {
  return a.text == b.text && a.moves_axes == b.moves_axes;
}

bool isSameProcess(const Path& a, const Path& b) {
  if (a.tool != b.tool || a.events.size() != b.events.size() || a.values.size() != b.values.size())
    return false;
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    const ToolpathEvent& event = a.events[i].event;
    const ToolpathEvent& other = b.events[i].event;
    if (a.events[i].motion != b.events[i].motion || event.index() != other.index()) return false;
    const auto isSame = [&](const auto& kind) {
      return isSameEvent(kind, std::get<std::decay_t<decltype(kind)>>(other));
    };
    if (!std::visit(isSame, event)) return false;
  }
  for (std::size_t i = 0; i < a.values.size(); ++i)
    for (std::size_t w = 0; w < a.points.size(); ++w)
      if (a.values[i].name != b.values[i].name || a.values[i].value.at(w) != b.values[i].value.at(w))
        return false;
  return true;
}

Path randomPath(Random& random, const Point3& start) {
  Path path;
  path.role = static_cast<PathRole>(random.below(kPathRoles));
  path.is_closed = path.role != PathRole::Travel && random.below(2) == 0;
  path.points.push_back(start);
  const std::size_t more = 1 + random.below(6);
  for (std::size_t i = 0; i < more; ++i)
    path.points.emplace_back(random.uniform(-1e3, 1e3), random.normal(0.0, 1e-3),
                             random.uniform(0.0, 1.0) / 3.0);
  std::vector<double> feeds;
  for (std::size_t i = 0; i < path.points.size(); ++i) feeds.push_back(random.uniform(1.0, 100.0));
  if (!path.is_closed) feeds[0] = feeds[1];
  path.feed_mm_s = random.below(2) == 0 ? AlongPath<double>(feeds[0]) : AlongPath<double>(feeds);
  path.bead = Bead{path.role == PathRole::Travel ? 0.0 : random.uniform(0.1, 1.0), random.uniform(0.1, 1.0)};
  if (random.below(2) == 0) addProcess(path, random);
  return path;
}

Toolpath randomToolpath(std::uint64_t seed) {
  Random random(seed);
  Toolpath toolpath;
  toolpath.layers.resize(1 + random.below(4));
  Point3 at = Point3::Zero();
  for (ToolpathLayer& layer : toolpath.layers) {
    const std::size_t paths = 1 + random.below(5);
    for (std::size_t p = 0; p < paths; ++p) {
      layer.paths.push_back(randomPath(random, at));
      at = layer.paths.back().lastPoint();
    }
  }
  return toolpath;
}

bool areSame(const Path& a, const Path& b) {
  bool is_same =
      a.role == b.role && a.is_closed == b.is_closed && a.points == b.points && isSameProcess(a, b);
  for (std::size_t i = 0; is_same && i < a.points.size(); ++i)
    is_same = a.bead.at(i) == b.bead.at(i) && a.feed_mm_s.at(i) == b.feed_mm_s.at(i) &&
              a.orientation.at(i).coeffs() == b.orientation.at(i).coeffs();
  return is_same;
}

Toolpath triangleAndTravel() {
  Path triangle;
  triangle.role = PathRole::OuterWall;
  triangle.is_closed = true;
  triangle.points = {{0, 0, 0.2}, {1.5, 0, 0.2}, {0, 1, 0.2}};
  triangle.bead = Bead{0.4, 0.2};
  triangle.feed_mm_s = 30.0;
  Path travel;
  travel.role = PathRole::Travel;
  travel.points = {{0, 0, 0.2}, {9, 0, 0.2}};
  travel.feed_mm_s = 150.0;
  Toolpath toolpath;
  toolpath.layers = {{0.2, 0.2, {triangle, travel}}};
  return toolpath;
}

TEST(Csv, WritesOneRowForEachMotionTarget) {
  EXPECT_EQ(written(triangleAndTravel()),
            "layer,path,role,closed,x_mm,y_mm,z_mm,qw,qx,qy,qz,bead_width_mm,bead_height_mm,feed_mm_s\n"
            "0,0,outer_wall,1,0,0,0.2,0,1,0,0,0.4,0.2,30\n"
            "0,0,outer_wall,1,1.5,0,0.2,0,1,0,0,0.4,0.2,30\n"
            "0,0,outer_wall,1,0,1,0.2,0,1,0,0,0.4,0.2,30\n"
            "0,0,outer_wall,1,0,0,0.2,0,1,0,0,0.4,0.2,30\n"
            "0,1,travel,0,0,0,0.2,0,1,0,0,0,0,150\n"
            "0,1,travel,0,9,0,0.2,0,1,0,0,0,0,150\n");
}

TEST(Csv, ReadsBackWhatWasWritten) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Toolpath toolpath = randomToolpath(seed);
    const Toolpath back = readCsv(written(toolpath), "");
    RC_ASSERT(back.layers.size() == toolpath.layers.size());
    for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
      const auto& a = toolpath.layers[l].paths;
      const auto& b = back.layers[l].paths;
      RC_ASSERT(std::equal(a.begin(), a.end(), b.begin(), b.end(), areSame));
    }
  }));
}

TEST(Csv, ReportsDropsFromBeadsInAColumnOfTheirOwn) {
  Toolpath toolpath = triangleAndTravel();
  Path drops = toolpath.layers[0].paths[0];
  drops.is_closed = false;
  drops.deposit = Deposit::Drops;
  drops.points = {{9, 0, 0.2}, {9, 0.4, 0.2}};
  toolpath.layers[0].paths.push_back(drops);
  const std::string text = written(toolpath);
  EXPECT_EQ(text.substr(0, text.find('\n')), std::string(kCsvHeader) + ",deposit");
  EXPECT_NE(text.find("0,1,travel,0,9,0,0.2,0,1,0,0,0,0,150,bead\n"), std::string::npos);
  EXPECT_NE(text.find("0,2,outer_wall,0,9,0.4,0.2,0,1,0,0,0.4,0.2,30,drops\n"), std::string::npos);
  const Toolpath back = readCsv(text, "");
  ASSERT_EQ(back.layers[0].paths.size(), 3U);
  EXPECT_EQ(back.layers[0].paths[0].deposit, Deposit::Bead);
  EXPECT_EQ(back.layers[0].paths[2].deposit, Deposit::Drops);
  EXPECT_TRUE(areSame(back.layers[0].paths[2], drops));
}

TEST(Csv, RefusesADepositItDoesNotKnow) {
  const std::string header = std::string(kCsvHeader) + ",deposit\n";
  const std::string row = "0,0,infill,0,0,0,0,0,1,0,0,1,1,1,drops\n";
  EXPECT_NO_THROW(readCsv(header + row, ""));
  for (const char* bad : {"0,0,infill,0,0,0,0,0,1,0,0,1,1,1,foam\n", "0,0,infill,0,0,0,0,0,1,0,0,1,1,1\n",
                          "0,0,infill,0,0,0,0,0,1,0,0,1,1,1,bead\n"})
    EXPECT_THROW(readCsv(header + row + bad, ""), InvalidProgram) << bad;
}

TEST(Csv, ReadsHeightAndThicknessOfALayer) {
  const Toolpath back = readCsv(written(triangleAndTravel()), "part");
  EXPECT_EQ(back.part_name, "part");
  EXPECT_DOUBLE_EQ(back.layers[0].z_mm, 0.2);
  EXPECT_DOUBLE_EQ(back.layers[0].height_mm, 0.2);
}

TEST(Csv, WritesATravelWithoutBeadWhateverItHolds) {
  Toolpath toolpath = triangleAndTravel();
  toolpath.layers[0].paths[1].bead = Bead{0.4, 0.2};
  EXPECT_NE(written(toolpath).find("travel,0,9,0,0.2,0,1,0,0,0,0.2,150\n"), std::string::npos);
}

TEST(Csv, RefusesAToolpathThatIsNotValidBeforeWriting) {
  Toolpath toolpath = triangleAndTravel();
  toolpath.layers[0].paths[1].points[0].x() = 5.0;
  EXPECT_THROW(writeCsv(toolpath, [](std::string_view) { FAIL(); }), InvalidInput);
}

TEST(Csv, RefusesBadRowsAndNamesTheLine) {
  const std::string header = std::string(kCsvHeader) + "\n";
  const std::string row = "0,0,infill,0,0,0,0,0,1,0,0,1,1,1\n";
  EXPECT_THROW(readCsv("", ""), InvalidProgram);
  EXPECT_THROW(readCsv("layer,path\n", ""), InvalidProgram);
  for (const char* bad : {"0,0,infill,0,0,0\n", "0,0,infill,0,0,0,0,0,1,0,0,1,1,1,1\n", "\n",
                          "0,0,infill,2,0,0,0,0,1,0,0,1,1,1\n", "0,0,infill,0,x,0,0,0,1,0,0,1,1,1\n",
                          "0,7,infill,0,0,0,0,0,1,0,0,1,1,1\n", "-1,0,infill,0,0,0,0,0,1,0,0,1,1,1\n"})
    EXPECT_THROW(readCsv(header + row + row + bad, ""), InvalidInput) << bad;
  try {
    readCsv(header + row + "oops\n", "");
    FAIL();
  } catch (const InvalidProgram& error) {
    EXPECT_NE(std::string(error.what()).find("line 3"), std::string::npos) << error.what();
  }
}

TEST(Csv, RefusesAClosedPathThatDoesNotReturn) {
  const std::string open = std::string(kCsvHeader) +
                           "\n0,0,infill,1,0,0,0,0,1,0,0,1,1,1\n0,0,infill,1,1,0,0,0,1,0,0,1,1,1\n"
                           "0,0,infill,1,1,1,0,0,1,0,0,1,1,1\n";
  EXPECT_THROW(readCsv(open, ""), InvalidProgram);
}

}  // namespace
}  // namespace lamina
