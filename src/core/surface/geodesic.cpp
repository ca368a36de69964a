// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/surface/geodesic.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A correction smaller than this share does not run through the mesh again.
constexpr double kRelevant = 1.0 - 1e-10;

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

}  // namespace

/// One run of the front over a mesh.
class GeodesicMarch {
 public:
  GeodesicMarch(const GeodesicDistances& mesh, const std::vector<GeodesicSource>& sources)
      : mesh_(mesh),
        sources_(sources),
        distance_(mesh.first_.size() - 1, kInfinity),
        origin_(sources.size() > 1 ? distance_.size() : 0, 0) {
    for (std::uint32_t i = 0; i < sources.size(); ++i) lower(sources[i].vertex, sources[i].start_mm, i);
  }

  std::vector<double> run() && {
    while (!front_.empty()) {
      const Reached reached = front_.front();
      std::pop_heap(front_.begin(), front_.end());
      front_.pop_back();
      if (reached.distance > distance_[reached.vertex]) continue;  // corrected since
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
    for (std::uint32_t i = mesh_.first_[vertex]; i < mesh_.first_[vertex + 1]; ++i) {
      const GeodesicDistances::Corner& corner = mesh_.corners_[i];
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

  const GeodesicDistances& mesh_;
  const std::vector<GeodesicSource>& sources_;
  std::vector<double> distance_;
  std::vector<std::uint32_t> origin_;  // number of the source that is nearest; empty if there is only one
  std::vector<Reached> front_;
};

GeodesicDistances::GeodesicDistances(const Mesh& mesh) : first_(mesh.vertices.size() + 1, 0) {
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= mesh.vertices.size())
        throw InvalidMesh("a triangle names vertex " + std::to_string(vertex) + "; the mesh has " +
                          std::to_string(mesh.vertices.size()));
      ++first_[vertex + 1];
    }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  corners_.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next_free(first_.begin(), first_.end() - 1);
  for (const Triangle& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      Corner& corner = corners_[next_free[triangle[i]]++];
      corner.next = triangle[(i + 1) % 3];
      corner.previous = triangle[(i + 2) % 3];
      const Point3 to_next = mesh.vertices[corner.next] - mesh.vertices[triangle[i]];
      const Point3 to_previous = mesh.vertices[corner.previous] - mesh.vertices[triangle[i]];
      corner.to_next = to_next.norm();
      corner.to_previous = to_previous.norm();
      corner.dot = to_next.dot(to_previous);
      corner.cross = to_next.cross(to_previous).norm();
    }
}

std::vector<double> GeodesicDistances::from(std::uint32_t source) const {
  return from(std::vector<GeodesicSource>{{source, 0.0}});
}

std::vector<double> GeodesicDistances::from(const std::vector<GeodesicSource>& sources) const {
  for (const GeodesicSource& source : sources) {
    if (source.vertex + 1 >= first_.size())
      throw InvalidInput("distances are asked for from vertex " + std::to_string(source.vertex) +
                         "; the mesh has " + std::to_string(first_.size() - 1));
    if (!(source.start_mm >= 0.0) || !std::isfinite(source.start_mm))
      throw InvalidInput("the distance at a source is " + std::to_string(source.start_mm) +
                         " mm; expected a finite number of at least 0");
  }
  return GeodesicMarch(*this, sources).run();
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
    for (std::uint32_t i = first_[here]; i < first_[here + 1]; ++i) {
      consider(corners_[i].next, corners_[i].to_next);
      consider(corners_[i].previous, corners_[i].to_previous);
    }
  }
  return way;
}

}  // namespace lamina
