// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/growth_fit.hpp"

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh/area_vector.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "slicing/volumetric/skin_samples.hpp"

namespace lamina {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

constexpr double kSmoothingCells = 2.0;
constexpr double kSkinWeight = 100.0;    // of the direction wanted at a skin, over that of the field there
constexpr double kFold = 0.5;            // cosine between neighbours' directions, below which fronts meet
constexpr double kFlat = 0.9998;         // cosine between normals of one flat face
constexpr double kThinnerShare = 0.005;  // of the volume
constexpr double kLevelGradient = 0.02;  // from that of level growth
constexpr double kLimbCells = 3.0;
constexpr double kFacetShare = 0.1;  // of the area of the largest face at an end
constexpr double kResidual = 1e-7;
constexpr int kIterations = 2000;
// Of the squares of the 26 ways to neighbours along any direction, each way counted from one of its ends.
constexpr double kPerLink = 3.0 / 13.0;

/// Part of the surface near a node.
struct SkinPart {
  std::uint32_t node = CellGraph::kNone;
  std::uint32_t triangle = 0;
  Point3 normal = Point3::Zero();
};

bool isSamePart(const SkinPart& a, const SkinPart& b) {
  return a.node == b.node && a.normal.dot(b.normal) > kFlat;
}

bool isBefore(const SkinPart& a, const SkinPart& b) { return a.node < b.node; }

/// The parts at a node, of parts by nodes.
std::pair<const SkinPart*, const SkinPart*> partsAt(const std::vector<SkinPart>& parts, std::uint32_t node) {
  const auto [first, last] = std::equal_range(parts.begin(), parts.end(), SkinPart{node}, isBefore);
  return {parts.data() + (first - parts.begin()), parts.data() + (last - parts.begin())};
}

/// By nodes; parts of one node that face the same way are one. A node that is but a sliver at the skin has
/// those of its neighbours that lie farther in.
std::vector<SkinPart> skinParts(const Mesh& mesh, const CellGraph& cells, Progress& progress) {
  std::vector<SkinPart> parts;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 4096 == 0) throwIfCancelled(progress, "fit");
    const Point3 normal = triangleNormal(mesh, i);
    std::array<Point3, 3> corner;
    for (std::size_t side = 0; side < 3; ++side) corner[side] = mesh.vertices[mesh.triangles[i][side]];
    visitParts(corner, cells.frame().voxel_mm, [&](const auto&, const Point3& place, double) {
      const SkinPart part{nodeBelow(cells, place, normal), i, normal};
      if (part.node != CellGraph::kNone && (parts.empty() || !isSamePart(part, parts.back())))
        parts.push_back(part);
    });
  }
  std::stable_sort(parts.begin(), parts.end(), isBefore);
  parts.erase(std::unique(parts.begin(), parts.end(), isSamePart), parts.end());
  std::vector<SkinPart> all = parts;
  for (const SkinPart& part : parts)
    for (const std::uint32_t near : cells.links(part.node)) {
      const auto [first, last] = partsAt(parts, near);
      if (first == last && part.normal.dot(cells.middle(near) - cells.middle(part.node)) > 0.0)
        all.push_back({near, part.triangle, part.normal});
    }
  std::stable_sort(all.begin(), all.end(), isBefore);
  return all;
}

/// A direction at an angle from another, in the plane of both.
Point3 atAngle(const Point3& direction, const Point3& from, double angle_rad) {
  const Point3 across = direction - direction.dot(from) * from;
  const double length = across.norm();
  if (length <= 0.0) return direction;
  return std::cos(angle_rad) * from + std::sin(angle_rad) / length * across;
}

/// Solves by conjugate gradients; the matrix holds its lower triangle.
class PoissonSolver {
 public:
  explicit PoissonSolver(const Matrix& matrix) : matrix_(matrix) {
    solver_.setTolerance(kResidual);
    solver_.setMaxIterations(kIterations);
    solver_.compute(matrix_);
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right, const Eigen::VectorXd& guess) const {
    return solver_.solveWithGuess(right, guess);
  }

 private:
  Matrix matrix_;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower, Eigen::IncompleteCholesky<double, Eigen::Lower>> solver_;
};

class GrowthFit {
 public:
  GrowthFit(const Mesh& mesh, const ArrivedGrowth& arrived, const GrowthFitRequest& request,
            Progress& progress)
      : mesh_(mesh),
        cells_(arrived.cells),
        arrival_(arrived.field),
        request_(request),
        progress_(progress),
        skin_(skinParts(mesh, arrived.cells, progress)),
        growth_(arrived.field.growth_mm) {
    arrived_.assign(cells_.nodeCount(), Point3::Zero());
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (isReached(node))
        arrived_[node] =
            arrival_.near(cells_.middle(node), node, cells_.middle(node), arrived.gauge).gradient;
    gradient_ = arrived_;
    is_followed_.assign(cells_.nodeCount(), 0);
    for (const SkinPart& part : skin_)
      if (isFollowed(part)) is_followed_[part.node] = 1;
  }

  ArrivalField run() {
    const std::vector<char> stands = standing();
    const PoissonSolver poisson(poissonMatrix(stands));
    const PoissonSolver smoothing(smoothingMatrix());
    const std::vector<Point3> along =
        request_.target == GrowthTarget::Tangent ? directionsAlong(endNormals()) : std::vector<Point3>();
    std::vector<Point3> wanted;
    for (int round = 0; round < request_.rounds; ++round) {
      progress_.report("fit", static_cast<double>(round) / request_.rounds);
      throwIfCancelled(progress_, "fit");
      wanted = wantedGradients(along.empty() ? smoothed(smoothing) : along, stands);
      fit(poisson, stands, wanted);
    }
    const double steepest = steepestGradient();
    if (steepest > 1.0) {
      for (Point3& gradient : wanted) gradient /= steepest;
      fit(poisson, stands, wanted);
    }
    return result();
  }

 private:
  bool isReached(std::uint32_t node) const { return std::isfinite(arrival_.growth_mm[node]); }
  double rise(std::uint32_t node) const { return cells_.middle(node).z() - arrival_.bed_mm; }

  /// Calls visit(a, b, weight) for each pair of linked nodes that growth reaches, a < b. Pairs at skins that
  /// layers follow weigh more.
  template <class Visit>
  void forEachLink(const Visit& visit) const {
    for (std::uint32_t a = 0; a < cells_.nodeCount(); ++a) {
      if (!isReached(a)) continue;
      for (const std::uint32_t b : cells_.links(a)) {
        if (b < a || !isReached(b)) continue;
        const double squared = (cells_.middle(b) - cells_.middle(a)).squaredNorm();
        const double weight = is_followed_[a] != 0 && is_followed_[b] != 0 ? kSkinWeight : 1.0;
        if (squared > 0.0)
          visit(a, b, weight * kPerLink * std::sqrt(cells_.volume(a) * cells_.volume(b)) / squared);
      }
    }
  }

  bool isFold(std::uint32_t a, std::uint32_t b) const {
    return arrived_[a].dot(arrived_[b]) < kFold * arrived_[a].norm() * arrived_[b].norm();
  }

  /// Where growth stays as it is.
  std::vector<char> standing() const {
    std::vector<char> stands(cells_.nodeCount(), 0);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      stands[node] = static_cast<char>(!isReached(node) ||
                                       (arrival_.is_level[node] != 0 &&
                                        cells_.corner(node).z() < arrival_.bed_mm + request_.first_layer_mm));
    return stands;
  }

  /// Of all nodes: one that is given has a row of its own.
  Matrix poissonMatrix(const std::vector<char>& given) const {
    std::vector<double> diagonal(cells_.nodeCount(), 0.0);
    std::vector<Triplet> entries;
    forEachLink([&](std::uint32_t a, std::uint32_t b, double weight) {
      diagonal[a] += weight;
      diagonal[b] += weight;
      if (given[a] == 0 && given[b] == 0) entries.emplace_back(b, a, -weight);
    });
    return matrixOf(std::move(entries), diagonal, given);
  }

  Matrix smoothingMatrix() const {
    const double reach = kSmoothingCells * cells_.frame().voxel_mm;
    std::vector<double> diagonal(cells_.nodeCount(), 0.0);
    std::vector<Triplet> entries;
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) diagonal[node] = cells_.volume(node);
    for (const SkinPart& part : skin_)
      if (isFollowed(part)) diagonal[part.node] += kSkinWeight * cells_.volume(part.node);
    forEachLink([&](std::uint32_t a, std::uint32_t b, double weight) {
      if (isFold(a, b)) return;
      const double coupling = reach * reach * weight;
      diagonal[a] += coupling;
      diagonal[b] += coupling;
      entries.emplace_back(b, a, -coupling);
    });
    return matrixOf(std::move(entries), diagonal, std::vector<char>(cells_.nodeCount(), 0));
  }

  Matrix matrixOf(std::vector<Triplet> entries, const std::vector<double>& diagonal,
                  const std::vector<char>& given) const {
    const auto count = static_cast<Eigen::Index>(diagonal.size());
    entries.reserve(entries.size() + diagonal.size());
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto node = static_cast<std::size_t>(i);
      const bool is_free = given[node] == 0 && diagonal[node] > 0.0;
      entries.emplace_back(i, i, is_free ? diagonal[node] : 1.0);
    }
    Matrix matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  /// Whether layers are to follow a part of the surface: it faces growth.
  bool isFollowed(const SkinPart& part) const {
    if (request_.target != GrowthTarget::Surface || !isReached(part.node)) return false;
    const Point3& arrived = arrived_[part.node];
    return part.normal.dot(arrived) >= std::cos(request_.skin_slope_rad) * arrived.norm();
  }

  /// Directions of the present field, smoothed.
  std::vector<Point3> smoothed(const PoissonSolver& smoothing) const {
    const auto count = static_cast<Eigen::Index>(cells_.nodeCount());
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(count, 3);
    Eigen::MatrixX3d guess = Eigen::MatrixX3d::Zero(count, 3);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      if (!isReached(node)) continue;
      guess.row(node) = gradient_[node].normalized();
      right.row(node) = cells_.volume(node) * guess.row(node);
    }
    for (const SkinPart& part : skin_)
      if (isFollowed(part)) {
        right.row(part.node) += kSkinWeight * cells_.volume(part.node) * part.normal;
        guess.row(part.node) = part.normal;
      }
    std::vector<Point3> directions(cells_.nodeCount(), Point3::Zero());
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Eigen::VectorXd solution = smoothing.solve(right.col(axis), guess.col(axis));
      for (Eigen::Index i = 0; i < count; ++i) directions[static_cast<std::size_t>(i)][axis] = solution[i];
    }
    return directions;
  }

  /// The normal at nodes at those flat faces of the surface that are farthest from the bed; 0 at the others.
  std::vector<Point3> endNormals() const {
    std::vector<char> is_end_face(mesh_.triangles.size(), 0);
    const std::vector<double> distances = distancesFromBed();
    for (const std::uint32_t node : farthestNodes(distances))
      for (const std::uint32_t triangle : endFace(node, distances)) is_end_face[triangle] = 1;
    std::vector<Point3> ends(cells_.nodeCount(), Point3::Zero());
    bool is_found = false;
    for (const SkinPart& part : skin_) {
      if (is_end_face[part.triangle] == 0 || !isReached(part.node)) continue;
      ends[part.node] = part.normal;
      is_found = true;
    }
    if (!is_found)
      throw Unsliceable(
          "no end of the part was found for volumetric.target=tangent; expected a face of the surface that "
          "is farther from the bed, through the part, than all around",
          mesh_);
    return ends;
  }

  /// Through the part, from node to node [mm].
  std::vector<double> distancesFromBed() const {
    using Reach = std::pair<double, std::uint32_t>;
    std::priority_queue<Reach, std::vector<Reach>, std::greater<>> queue;
    std::vector<double> distances(cells_.nodeCount(), std::numeric_limits<double>::infinity());
    const std::vector<char> stands = standing();
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (stands[node] != 0 && isReached(node)) {
        distances[node] = 0.0;
        queue.emplace(0.0, node);
      }
    while (!queue.empty()) {
      const auto [distance, node] = queue.top();
      queue.pop();
      if (distance > distances[node]) continue;
      for (const std::uint32_t near : cells_.links(node)) {
        const double next = distance + (cells_.middle(near) - cells_.middle(node)).norm();
        if (!isReached(near) || next >= distances[near]) continue;
        distances[near] = next;
        queue.emplace(next, near);
      }
    }
    return distances;
  }

  /// Of each limb of the part the node farthest from the bed: what is farther is joined to it only by what is
  /// nearer by more than a few cells.
  std::vector<std::uint32_t> farthestNodes(const std::vector<double>& distances) const {
    std::vector<std::uint32_t> order;
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (isReached(node)) order.push_back(node);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return distances[a] > distances[b]; });
    std::vector<std::uint32_t> farthest(cells_.nodeCount(), CellGraph::kNone);  // of the limb, or towards it
    const auto farthestOf = [&](std::uint32_t node) {
      while (farthest[node] != node) node = farthest[node] = farthest[farthest[node]];
      return node;
    };
    std::vector<char> is_limb(cells_.nodeCount(), 0);
    for (const std::uint32_t node : order) {
      farthest[node] = node;
      is_limb[node] = 1;
      for (const std::uint32_t near : cells_.links(node)) {
        if (farthest[near] == CellGraph::kNone) continue;
        std::uint32_t limb = farthestOf(near);
        std::uint32_t own = farthestOf(node);
        if (limb == own) continue;
        if (distances[limb] < distances[own] || (distances[limb] == distances[own] && limb > own))
          std::swap(limb, own);
        farthest[own] = limb;
        if (distances[own] - distances[node] < kLimbCells * cells_.frame().voxel_mm) is_limb[own] = 0;
      }
    }
    std::vector<std::uint32_t> ends;
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (is_limb[node] != 0) ends.push_back(node);
    return ends;
  }

  /// The flat face of the surface at a node, or beside it, that is farthest from the bed on average. Faces
  /// much smaller than the largest there are facets of a round wall.
  TriangleNumbers endFace(std::uint32_t node, const std::vector<double>& distances) const {
    std::vector<TriangleNumbers> faces;
    std::vector<double> areas;
    const auto look = [&](std::uint32_t at) {
      const auto [first, last] = partsAt(skin_, at);
      for (const SkinPart* part = first; part != last; ++part) {
        faces.push_back(flatFace(part->triangle));
        double area = 0.0;
        for (const std::uint32_t triangle : faces.back()) area += triangleArea(mesh_, triangle);
        areas.push_back(area);
      }
    };
    look(node);
    for (const std::uint32_t near : cells_.links(node)) look(near);
    if (faces.empty()) return {};
    const double least_area = kFacetShare * *std::max_element(areas.begin(), areas.end());
    std::size_t best = 0;
    double farthest = -1.0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const double distance = areas[i] < least_area ? -1.0 : meanDistance(faces[i], distances);
      if (distance <= farthest) continue;
      farthest = distance;
      best = i;
    }
    return std::move(faces[best]);
  }

  double meanDistance(const TriangleNumbers& face, const std::vector<double>& distances) const {
    double sum = 0.0;
    double parts = 0.0;
    for (const SkinPart& part : skin_) {
      if (!isReached(part.node) || !std::binary_search(face.begin(), face.end(), part.triangle)) continue;
      sum += distances[part.node];
      parts += 1.0;
    }
    return parts > 0.0 ? sum / parts : 0.0;
  }

  /// Triangles in the plane of one, that face as it does.
  TriangleNumbers flatFace(std::uint32_t triangle) const {
    const Point3 normal = triangleNormal(mesh_, triangle);
    const Point3& on = mesh_.vertices[mesh_.triangles[triangle][0]];
    TriangleNumbers face;
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i)
      if (std::abs((mesh_.vertices[mesh_.triangles[i][0]] - on).dot(normal)) < cells_.bitSide() &&
          triangleNormal(mesh_, i).dot(normal) > kFlat)
        face.push_back(i);
    return face;
  }

  /// Gradient of the harmonic field between bed and ends.
  std::vector<Point3> directionsAlong(const std::vector<Point3>& ends) const {
    std::vector<char> given = standing();
    std::vector<double> value(cells_.nodeCount(), 0.0);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (!ends[node].isZero() && given[node] == 0) {
        given[node] = 1;
        value[node] = 1.0;
      }
    const auto count = static_cast<Eigen::Index>(cells_.nodeCount());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    forEachLink([&](std::uint32_t a, std::uint32_t b, double weight) {
      if (given[a] == 0 && given[b] != 0) right[a] += weight * value[b];
      if (given[b] == 0 && given[a] != 0) right[b] += weight * value[a];
    });
    for (Eigen::Index i = 0; i < count; ++i)
      if (given[static_cast<std::size_t>(i)] != 0) right[i] = value[static_cast<std::size_t>(i)];
    const Eigen::VectorXd field =
        PoissonSolver(poissonMatrix(given)).solve(right, Eigen::VectorXd::Zero(count));
    std::vector<Point3> along = gradientsOf(std::vector<double>(field.data(), field.data() + count));
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (!ends[node].isZero()) along[node] = ends[node];
    return along;
  }

  /// Directions within the limits, of the length that growth is to have.
  std::vector<Point3> wantedGradients(std::vector<Point3> directions, const std::vector<char>& stands) const {
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      if (!isReached(node)) continue;
      Point3& direction = directions[node];
      if (!(direction.norm() > 0.0)) direction = arrived_[node];
      direction.normalize();
    }
    const double deepest = -std::sin(request_.limits.overhang_rad);
    for (const SkinPart& part : skin_) {
      Point3& direction = directions[part.node];
      if (stands[part.node] == 0 && part.normal.dot(direction) < deepest)
        direction = atAngle(direction, part.normal, M_PI_2 + request_.limits.overhang_rad);
    }
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      if (!isReached(node)) continue;
      Point3& direction = directions[node];
      if (direction.z() < std::cos(request_.limits.max_tilt_rad))
        direction = atAngle(direction, Point3::UnitZ(), request_.limits.max_tilt_rad);
      if (request_.target != GrowthTarget::Tangent)
        direction *= std::clamp(arrived_[node].norm(), 1.0 / request_.limits.max_thickness, 1.0);
    }
    return directions;
  }

  /// The field whose gradient is nearest to that wanted; across folds it differs as the arrival does.
  void fit(const PoissonSolver& poisson, const std::vector<char>& stands, const std::vector<Point3>& wanted) {
    const auto count = static_cast<Eigen::Index>(cells_.nodeCount());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd guess = Eigen::VectorXd::Zero(count);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (isReached(node)) guess[node] = growth_[node];
    forEachLink([&](std::uint32_t a, std::uint32_t b, double weight) {
      const Point3 way = cells_.middle(b) - cells_.middle(a);
      const double difference =
          isFold(a, b) ? arrival_.growth_mm[b] - arrival_.growth_mm[a] : 0.5 * way.dot(wanted[a] + wanted[b]);
      right[a] -= weight * (difference - (stands[b] != 0 ? growth_[b] : 0.0));
      right[b] += weight * (difference + (stands[a] != 0 ? growth_[a] : 0.0));
    });
    for (Eigen::Index i = 0; i < count; ++i)
      if (stands[static_cast<std::size_t>(i)] != 0) right[i] = guess[i];
    const Eigen::VectorXd field = poisson.solve(right, guess);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (isReached(node)) growth_[node] = field[node];
    gradient_ = gradientsOf(growth_);
  }

  /// By least squares over neighbours on the same side of folds; that of the arrival where these are too few.
  std::vector<Point3> gradientsOf(const std::vector<double>& field) const {
    std::vector<Point3> gradients = arrived_;
    const auto find = [&](std::size_t i) {
      const auto node = static_cast<std::uint32_t>(i);
      if (!isReached(node)) return;
      Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
      Point3 right = Point3::Zero();
      for (const std::uint32_t near : cells_.links(node)) {
        if (!isReached(near) || isFold(node, near)) continue;
        const Point3 way = cells_.middle(near) - cells_.middle(node);
        square += way * way.transpose() / way.squaredNorm();
        right += way * (field[near] - field[node]) / way.squaredNorm();
      }
      if (square.determinant() > 1e-3) gradients[node] = square.ldlt().solve(right);
    };
    constexpr std::size_t kBlock = 4096;
    const std::size_t count = cells_.nodeCount();
    parallelFor((count + kBlock - 1) / kBlock,
                [&](std::size_t block) {
                  for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i)
                    find(i);
                },
                progress_, "fit");
    return gradients;
  }

  /// Length of the gradient that is exceeded in a small share of the volume only.
  double steepestGradient() const {
    std::vector<std::pair<double, double>> lengths;  // with the volume
    double whole = 0.0;
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      if (!isReached(node)) continue;
      lengths.emplace_back(gradient_[node].norm(), cells_.volume(node));
      whole += lengths.back().second;
    }
    std::sort(lengths.begin(), lengths.end());
    double above = 0.0;
    for (auto length = lengths.rbegin(); length != lengths.rend(); ++length) {
      above += length->second;
      if (above > kThinnerShare * whole) return length->first;
    }
    return 0.0;
  }

  ArrivalField result() const {
    ArrivalField field = arrival_;
    field.growth_mm = growth_;
    field.fitted_gradient = gradient_;
    const double tolerance = kLevelCells * cells_.frame().voxel_mm;
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      if (!isReached(node)) continue;
      field.is_level[node] = static_cast<char>(std::abs(growth_[node] - rise(node)) <= tolerance &&
                                               (gradient_[node] - Point3::UnitZ()).norm() <= kLevelGradient);
      if (field.is_level[node] != 0) field.growth_mm[node] = rise(node);
    }
    return field;
  }

  const Mesh& mesh_;
  const CellGraph& cells_;
  const ArrivalField& arrival_;
  const GrowthFitRequest& request_;
  Progress& progress_;
  std::vector<SkinPart> skin_;
  std::vector<char> is_followed_;  // nodes at skins that layers follow
  std::vector<Point3> arrived_;    // gradients of the arrival field
  std::vector<double> growth_;     // of the present fit
  std::vector<Point3> gradient_;   // of the present fit
};

}  // namespace

ArrivalField fittedGrowth(const Mesh& mesh, const ArrivedGrowth& arrived, const GrowthFitRequest& request,
                          Progress& progress) {
  return GrowthFit(mesh, arrived, request, progress).run();
}

ArrivalField blendedGrowth(const ArrivedGrowth& arrived, const ArrivalField& fitted, double share) {
  ArrivalField blended = fitted;
  for (std::uint32_t node = 0; node < arrived.cells.nodeCount(); ++node) {
    if (!std::isfinite(arrived.field.growth_mm[node])) continue;
    const Point3& middle = arrived.cells.middle(node);
    const GrowthAt there = arrived.field.near(middle, node, middle, arrived.gauge);
    blended.growth_mm[node] += (1.0 - share) * (arrived.field.growth_mm[node] - fitted.growth_mm[node]);
    blended.fitted_gradient[node] += (1.0 - share) * (there.gradient - fitted.fitted_gradient[node]);
    blended.is_level[node] =
        static_cast<char>(arrived.field.is_level[node] != 0 && fitted.is_level[node] != 0);
  }
  return blended;
}

}  // namespace lamina
