// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/geodesic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A correction smaller than this share does not run through the mesh again.
constexpr double kRelevant = 1.0 - 1e-10;

// Around slivers, distances may lower each other in turn by ever so little, for as good as ever. Nothing else
// is corrected so often.
constexpr std::uint8_t kMostCorrections = 250;

/// A side of a triangle from A at the origin to B on the x axis, and the third vertex C above it.
struct Crossing {
  double side;
  double x;
  double y;
};

/// Whether the angle at C exceeds a right one: only then can a wave reach C before A and B.
bool isObtuse(const Crossing& triangle) {
  return triangle.x * (triangle.side - triangle.x) > triangle.y * triangle.y;
}

/// Distance of C of the circular wave that is `a` and `b` from its centre at A and B; infinite if the way
/// from there to C passes the side by. The centre lies below the side.
double acrossAsCircle(const Crossing& triangle, double a, double b) {
  const double centre_x = (a * a - b * b + triangle.side * triangle.side) / (2.0 * triangle.side);
  const double depth_squared = a * a - centre_x * centre_x;
  if (depth_squared < 0.0) return kInfinity;
  const double depth = std::sqrt(depth_squared);
  const double passage = centre_x * triangle.y + triangle.x * depth;
  const double height = triangle.y + depth;
  if (passage < 0.0 || passage > triangle.side * height) return kInfinity;
  const double dx = triangle.x - centre_x;
  return std::sqrt(dx * dx + height * height);
}

/// The same for the straight wave that is `a` and `b` at A and B.
double acrossAsLine(const Crossing& triangle, double a, double b) {
  const double slope = (b - a) / triangle.side;
  const double rise_squared = 1.0 - slope * slope;
  if (rise_squared <= 0.0) return kInfinity;
  const double rise = std::sqrt(rise_squared);
  const double passage = triangle.x - triangle.y * slope / rise;
  if (passage < 0.0 || passage > triangle.side) return kInfinity;
  return a + slope * triangle.x + rise * triangle.y;
}

/// One run of the front over a mesh.
class GeodesicMarch {
 public:
  GeodesicMarch(const TriangleFans& fans, const std::vector<GeodesicSource>& sources)
      : fans_(fans),
        sources_(sources),
        distance_(fans.vertices(), kInfinity),
        corrections_(fans.vertices(), 0),
        origin_(sources.size() > 1 ? distance_.size() : 0, 0) {
    for (std::uint32_t i = 0; i < sources.size(); ++i) lower(sources[i].vertex, sources[i].start_mm, i);
  }

  std::vector<double> run() && {
    while (!front_.empty()) {
      const Reached reached = front_.front();
      std::pop_heap(front_.begin(), front_.end());
      front_.pop_back();
      if (reached.distance > distance_[reached.vertex]) continue;  // corrected since
      if (corrections_[reached.vertex]++ == kMostCorrections) {
        corrections_[reached.vertex] = kMostCorrections;
        continue;
      }
      spreadFrom(reached.vertex);
    }
    return std::move(distance_);
  }

 private:
  struct Reached {
    double distance;
    std::uint32_t vertex;
    bool operator<(const Reached& other) const {  // the nearest is taken first
      return distance != other.distance ? distance > other.distance : vertex > other.vertex;
    }
  };

  std::uint32_t originOfVertex(std::uint32_t vertex) const { return origin_.empty() ? 0 : origin_[vertex]; }

  /// Sides of no length give a distance that is no number, and lower nothing.
  void lower(std::uint32_t vertex, double distance, std::uint32_t origin) {
    if (!(distance < distance_[vertex] * kRelevant)) return;
    distance_[vertex] = distance;
    if (!origin_.empty()) origin_[vertex] = origin;
    front_.push_back({distance, vertex});
    std::push_heap(front_.begin(), front_.end());
  }

  void spreadFrom(std::uint32_t vertex) {
    for (std::uint32_t i = fans_.first[vertex]; i < fans_.first[vertex + 1]; ++i) {
      const FanCorner& corner = fans_.corners[i];
      run(vertex, corner.next, corner.to_next);
      run(vertex, corner.previous, corner.to_previous);
      cross(vertex, corner.previous, corner.next,
            {corner.to_previous, corner.dot / corner.to_previous, corner.cross / corner.to_previous});
      cross(vertex, corner.next, corner.previous,
            {corner.to_next, corner.dot / corner.to_next, corner.cross / corner.to_next});
    }
  }

  void run(std::uint32_t from, std::uint32_t to, double length) {
    lower(to, distance_[from] + length, originOfVertex(from));
  }

  void cross(std::uint32_t a, std::uint32_t b, std::uint32_t to, const Crossing& triangle) {
    const double at_a = distance_[a];
    const double at_b = distance_[b];
    if (at_b == kInfinity || (!isObtuse(triangle) && distance_[to] <= std::min(at_a, at_b))) return;
    const std::uint32_t origin = originOfVertex(a);
    if (origin == originOfVertex(b)) {
      const double start = sources_[origin].start_mm;
      lower(to, start + acrossAsCircle(triangle, at_a - start, at_b - start), origin);
    } else {
      lower(to, acrossAsLine(triangle, at_a, at_b), at_a < at_b ? origin : originOfVertex(b));
    }
  }

  const TriangleFans& fans_;
  const std::vector<GeodesicSource>& sources_;
  std::vector<double> distance_;
  std::vector<std::uint8_t> corrections_;
  std::vector<std::uint32_t> origin_;  // number of the source that is nearest; empty if there is only one
  std::vector<Reached> front_;
};

}  // namespace

GeodesicDistances::GeodesicDistances(const Mesh& mesh) : fans_(gatherFans(mesh)) {}

GeodesicDistances::GeodesicDistances(TriangleFans fans) : fans_(std::move(fans)) {}

std::vector<double> GeodesicDistances::from(std::uint32_t source) const {
  return from(std::vector<GeodesicSource>{{source, 0.0}});
}

std::vector<double> GeodesicDistances::from(const std::vector<GeodesicSource>& sources) const {
  for (const GeodesicSource& source : sources) {
    if (source.vertex >= fans_.vertices())
      throw InvalidInput("distances are asked for from vertex " + std::to_string(source.vertex) +
                         "; the mesh has " + std::to_string(fans_.vertices()));
    if (!(source.start_mm >= 0.0) || !std::isfinite(source.start_mm))
      throw InvalidInput("the distance at a source is " + numberText(source.start_mm) +
                         " mm; expected a finite number of at least 0");
  }
  return GeodesicMarch(fans_, sources).run();
}

std::vector<std::uint32_t> GeodesicDistances::descend(const std::vector<double>& distance,
                                                      std::uint32_t vertex) const {
  std::vector<std::uint32_t> way;
  for (std::uint32_t next = vertex; way.empty() || next != way.back();) {
    way.push_back(next);
    const std::uint32_t here = next;
    double steepest = 0.0;
    const auto consider = [&](std::uint32_t other, double length) {
      const double fall = distance[here] - distance[other];
      if (!(fall > steepest * length)) return;
      steepest = length > 0.0 ? fall / length : kInfinity;
      next = other;
    };
    for (std::uint32_t i = fans_.first[here]; i < fans_.first[here + 1]; ++i) {
      consider(fans_.corners[i].next, fans_.corners[i].to_next);
      consider(fans_.corners[i].previous, fans_.corners[i].to_previous);
    }
  }
  return way;
}

}  // namespace lamina
