// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/gmsh_geometry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "sweep/specimen.hpp"

namespace lamina {
namespace {

/// A curve of the file: a straight line, or an arc round a centre, by points.
struct ReadCurve {
  int from = 0;
  int centre = -1;
  int to = 0;
};

std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  static const std::regex kNumber(R"([-+]?[0-9.]+(?:e[-+]?[0-9]+)?)");
  for (std::sregex_iterator i(text.begin(), text.end(), kNumber), end; i != end; ++i)
    numbers.push_back(std::stod(i->str()));
  return numbers;
}

/// Reads what `gmshGeometry` writes as Gmsh would, and measures its volumes one by one.
class GeometryReader {
 public:
  explicit GeometryReader(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) read(line);
  }

  std::vector<double> prisms;
  std::vector<double> joints;
  std::size_t beads = 0;
  std::string kernel;
  bool is_named = false;

 private:
  void read(const std::string& line) {
    static const std::regex kAssignment(R"(^(Point|Line|Circle)\([pn]\+(\d+)\) = \{(.*)\};$)");
    static const std::regex kLoop(R"(^Curve Loop\(n\) = \{n\+1:n\+(\d+)\};$)");
    std::smatch match;
    if (line == "p = newp; n = newreg;") {
      points_.clear();
      curves_.clear();
    } else if (std::regex_match(line, match, kAssignment)) {
      assign(match[1], std::stoi(match[2]), numbersIn(match[3]), match[3]);
    } else if (std::regex_match(line, match, kLoop)) {
      EXPECT_EQ(static_cast<std::size_t>(std::stoi(match[1])), curves_.size());
      expectClosed();
    } else if (line.rfind("v[] = Extrude {{", 0) == 0) {
      joints.push_back(revolved(numbersIn(line)));
    } else if (line.rfind("v[] = Extrude {", 0) == 0) {
      const std::vector<double> way = numbersIn(line);
      prisms.push_back(std::abs(areaVector().dot(Point3(way[0], way[1], way[2]))));
    } else if (line == "beads[] += v[1];") {
      ++beads;
    } else if (line.rfind("SetFactory", 0) == 0) {
      kernel = line;
    } else if (line == "Physical Volume(\"beads\") = beads[];") {
      is_named = true;
    } else {
      EXPECT_TRUE(line == "Plane Surface(n) = {n};" || line == "beads[] = {};" || line.rfind("//", 0) == 0)
          << line;
    }
  }

  void assign(const std::string& kind, int number, const std::vector<double>& values,
              const std::string& text) {
    if (kind == "Point") {
      points_[number] = Point3(values.at(0), values.at(1), values.at(2));
      return;
    }
    EXPECT_EQ(text.find("p+"), 0U);
    const auto at = [&](std::size_t i) { return static_cast<int>(values.at(i)); };
    if (kind == "Line") curves_[number] = {at(0), -1, at(1)};
    if (kind == "Circle") curves_[number] = {at(0), at(1), at(2)};
  }

  void expectClosed() const {
    for (const auto& [number, curve] : curves_) {
      const auto next = curves_.count(number + 1) > 0 ? curves_.at(number + 1) : curves_.at(1);
      EXPECT_EQ(curve.to, next.from);
      if (curve.centre < 0) continue;
      const Point3& centre = points_.at(curve.centre);
      EXPECT_NEAR((points_.at(curve.from) - centre).norm(), (points_.at(curve.to) - centre).norm(), 1e-7);
    }
  }

  /// The outline as chords, fine enough for 1e-7 of its area.
  std::vector<Point3> outline() const {
    std::vector<Point3> points;
    constexpr int kChords = 2000;
    for (const auto& [number, curve] : curves_) {
      const Point3 from = points_.at(curve.from);
      points.push_back(from);
      if (curve.centre < 0) continue;
      const Point3 a = from - points_.at(curve.centre);
      const Point3 b = points_.at(curve.to) - points_.at(curve.centre);
      const double angle = std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
      for (int i = 1; i < kChords; ++i) {
        const double part = angle * i / kChords;
        points.push_back(points_.at(curve.centre) +
                         (std::sin(angle - part) * a + std::sin(part) * b) / std::sin(angle));
      }
    }
    return points;
  }

  Point3 areaVector() const {
    const std::vector<Point3> points = outline();
    Point3 sum = Point3::Zero();
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
      sum += 0.5 * (points[i] - points[0]).cross(points[i + 1] - points[0]);
    return sum;
  }

  /// Pappus: area times the way of its centre of mass about the axis.
  double revolved(const std::vector<double>& numbers) const {
    const Point3 axis(numbers[0], numbers[1], numbers[2]);
    const Point3 on_axis(numbers[3], numbers[4], numbers[5]);
    const std::vector<Point3> points = outline();
    const Point3 normal = areaVector().normalized();
    double moment = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const double area = 0.5 * (points[i] - points[0]).cross(points[i + 1] - points[0]).dot(normal);
      const Point3 middle = (points[0] + points[i] + points[i + 1]) / 3.0 - on_axis;
      moment += area * axis.cross(normal).normalized().dot(middle);
    }
    return 2.0 * M_PI * std::abs(moment);
  }

  std::map<int, Point3> points_;
  std::map<int, ReadCurve> curves_;
};

Sweep sweepThrough(std::vector<Point3> points, const Bead& bead) {
  Sweep sweep;
  sweep.points = std::move(points);
  sweep.up.assign(sweep.points.size(), Point3::UnitZ());
  sweep.bead = bead;
  return sweep;
}

/// Of a stadium wider than high, revolved about its upright middle: a disc with a round rim.
double jointVolume(const Bead& bead) {
  const double r = 0.5 * bead.height_mm, a = 0.5 * (bead.width_mm - bead.height_mm);
  return M_PI * (2.0 * r * a * a + M_PI * r * r * a + 4.0 / 3.0 * r * r * r);
}

TEST(GmshGeometry, ReadBackHasTheVolumeOfEachLineAndJoint) {
  const Bead bead{0.48, 0.3};
  const GeometryReader read(gmshGeometry({sweepThrough({{0, 0, 0.3}, {5, 0, 0.3}, {5, 3, 0.3}}, bead),
                                          sweepThrough({{1, 1, 0.6}, {1, 4, 0.6}}, bead)}));
  const double section = 0.3 * 0.18 + M_PI * 0.09 / 4.0;
  ASSERT_EQ(read.prisms.size(), 3U);
  EXPECT_NEAR(read.prisms[0], 5.0 * section, 1e-5);
  EXPECT_NEAR(read.prisms[1], 3.0 * section, 1e-5);
  EXPECT_NEAR(read.prisms[2], 3.0 * section, 1e-5);
  ASSERT_EQ(read.joints.size(), 1U);
  EXPECT_NEAR(read.joints[0], jointVolume(bead), 1e-6);
  EXPECT_EQ(read.beads, 4U);
  EXPECT_EQ(read.kernel, "SetFactory(\"OpenCASCADE\");");
  EXPECT_TRUE(read.is_named);
}

TEST(GmshGeometry, HoldsWhatIsSweptWhateverTheBeadAndItsTilt) {
  EXPECT_TRUE(rc::check("random sweeps", [](std::uint64_t seed) {
    Random random(seed);
    Sweep sweep;
    sweep.bead = {random.uniform(0.2, 1.0), random.uniform(0.1, 0.6)};
    const Point3 tilt = Point3(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 1.0).normalized();
    // Straight: whatever the tilt, the profile stands square to the line.
    const Point3 way = tilt.cross(Point3(random.uniform(-1, 1), random.uniform(-1, 1), 0.3)).normalized();
    sweep.points = {Point3(1, 2, 3), Point3(1, 2, 3) + random.uniform(0.5, 9.0) * way};
    sweep.up = {tilt, tilt};
    const GeometryReader read(gmshGeometry({sweep}));
    RC_ASSERT(read.prisms.size() == 1U);
    RC_ASSERT(std::abs(read.prisms[0] / sweptVolume({sweep}) - 1.0) < 1e-5);
  }));
}

TEST(GmshGeometry, RefusesNothing) { EXPECT_THROW(gmshGeometry({}), InvalidInput); }

}  // namespace
}  // namespace lamina
