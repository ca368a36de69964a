// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/growth_fit.hpp"

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "slicing/volumetric/even_lengths.hpp"
#include "slicing/volumetric/limb_ends.hpp"
#include "slicing/volumetric/skin_parts.hpp"

namespace lamina {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

constexpr double kSmoothingCells = 2.0;
constexpr double kSkinWeight = 100.0;    // of the direction wanted at a skin, over that of the field there
constexpr double kFold = 0.5;            // cosine between neighbours' directions, below which fronts meet
constexpr double kThinnerShare = 0.005;  // of the volume
constexpr double kLevelGradient = 0.02;  // from that of level growth
constexpr double kResidual = 1e-7;
constexpr int kIterations = 2000;
constexpr double kOnBedMm = 1e-9;
// Of the squares of the 26 ways to neighbours along any direction, each way counted from one of its ends.
constexpr double kPerLink = 3.0 / 13.0;

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
    gradient_ = request.target == GrowthTarget::Given ? request.given : arrived_;
    is_followed_.assign(cells_.nodeCount(), 0);
    for (const SkinPart& part : skin_)
      if (isFollowed(part)) is_followed_[part.node] = 1;
  }

  ArrivalField run() {
    const std::vector<char> foot = standing();
    const std::vector<Point3> along =
        request_.target == GrowthTarget::Tangent ? gradientsAlong(foot) : std::vector<Point3>();
    const std::vector<char> stands = isFree() ? anchors() : foot;
    const PoissonSolver poisson(poissonMatrix(stands));
    const PoissonSolver smoothing(smoothingMatrix());
    std::vector<Point3> wanted;
    for (int round = 0; round < request_.rounds; ++round) {
      progress_.report("fit", static_cast<double>(round) / request_.rounds);
      throwIfCancelled(progress_, "fit");
      wanted = wantedGradients(directionsFor(smoothing, along), foot);
      fit(poisson, stands, wanted);
    }
    const double steepest = steepestGradient();
    if (steepest > 1.0) {
      for (Point3& gradient : wanted) gradient /= steepest;
      fit(poisson, stands, wanted);
    }
    if (isFree()) beginAtBed();
    return result();
  }

 private:
  bool isFree() const { return request_.foot == GrowthFoot::Free; }

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

  /// Where growth stays as it is, unless the foot is free; what lies next to the bed need not be level then.
  std::vector<char> standing() const {
    std::vector<char> stands(cells_.nodeCount(), 0);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      stands[node] = static_cast<char>(!isReached(node) ||
                                       ((isFree() || arrival_.is_level[node] != 0) &&
                                        cells_.corner(node).z() < arrival_.bed_mm + request_.first_layer_mm));
    return stands;
  }

  /// The body that each node belongs to, of those that links join; `kNone` where growth does not reach.
  std::vector<std::uint32_t> bodies() const {
    std::vector<std::uint32_t> body(cells_.nodeCount(), CellGraph::kNone);
    std::vector<std::uint32_t> open;
    open.reserve(cells_.nodeCount());
    for (std::uint32_t first = 0; first < cells_.nodeCount(); ++first) {
      if (!isReached(first) || body[first] != CellGraph::kNone) continue;
      body[first] = first;
      for (open.push_back(first); !open.empty();) {
        const std::uint32_t node = open.back();
        open.pop_back();
        for (const std::uint32_t near : cells_.links(node)) {
          if (!isReached(near) || body[near] != CellGraph::kNone) continue;
          body[near] = first;
          open.push_back(near);
        }
      }
    }
    return body;
  }

  /// One node of each body, for a field whose foot is free but for a constant.
  std::vector<char> anchors() const {
    std::vector<char> stands(cells_.nodeCount(), 0);
    const std::vector<std::uint32_t> body = bodies();
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      stands[node] = static_cast<char>(body[node] == CellGraph::kNone || body[node] == node);
    return stands;
  }

  /// The least growth at the corners of a node's bits; those within half a bit of the bed are on it.
  double leastGrowth(std::uint32_t node) const {
    const Point3& gradient = gradient_[node];
    const double half = 0.5 * cells_.bitSide();
    double least = std::numeric_limits<double>::infinity();
    for (int bit = 0; bit < 64; ++bit) {
      if ((cells_.bits(node) >> bit & 1U) == 0) continue;
      Point3 corner = cells_.corner(node);
      const int layer = bit / 16;
      const int row = bit / 4 % 4;
      corner += cells_.bitSide() * Point3(bit % 4 + 0.5, row + 0.5, layer + 0.5);
      corner -= half * Point3(gradient.array().sign());
      if (corner.z() < arrival_.bed_mm + half + kOnBedMm) corner.z() = arrival_.bed_mm;
      least = std::min(least, gradient.dot(corner - cells_.middle(node)));
    }
    return growth_[node] + least;
  }

  /// Moves growth so that it begins with 0 in each body.
  void beginAtBed() {
    const std::vector<std::uint32_t> body = bodies();
    std::vector<double> least(cells_.nodeCount(), std::numeric_limits<double>::infinity());
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (body[node] != CellGraph::kNone) least[body[node]] = std::min(least[body[node]], leastGrowth(node));
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (body[node] != CellGraph::kNone) growth_[node] -= least[body[node]];
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

  /// What the next round is fitted to.
  /// @param along  gradients along the part, if that is the target
  std::vector<Point3> directionsFor(const PoissonSolver& smoothing, const std::vector<Point3>& along) const {
    switch (request_.target) {
      case GrowthTarget::Tangent:
        return along;
      case GrowthTarget::Given:
        return givenGradients();
      default:
        return smoothed(smoothing);
    }
  }

  /// Along the given directions as steep as the present field is: which lengths make a gradient of directions
  /// is not known beforehand.
  std::vector<Point3> givenGradients() const {
    std::vector<Point3> gradients = request_.given;
    const double most = request_.limits.max_thickness;
    for (std::size_t node = 0; node < gradients.size(); ++node)
      gradients[node] *= std::clamp(gradient_[node].dot(gradients[node]), 1.0 / most, most);
    return gradients;
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

  /// As `LimbQuestion` has them.
  std::vector<double> depthsIn(const PoissonSolver& poisson, const std::vector<char>& stands) const {
    const auto count = static_cast<Eigen::Index>(cells_.nodeCount());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (stands[node] == 0) right[node] = cells_.volume(node);
    const Eigen::VectorXd field = poisson.solve(right, Eigen::VectorXd::Zero(count));
    std::vector<double> depths(cells_.nodeCount(), -1.0);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (isReached(node)) depths[node] = std::max(0.0, field[node]);
    return depths;
  }

  /// Along the part from the bed to its ends, by the harmonic field between them.
  std::vector<Point3> gradientsAlong(const std::vector<char>& stands) const {
    const std::vector<double> depths = depthsIn(PoissonSolver(poissonMatrix(stands)), stands);
    const std::vector<Point3> ends = limbEnds({mesh_, cells_, skin_, depths});
    if (std::all_of(ends.begin(), ends.end(), [](const Point3& normal) { return normal.isZero(); }))
      throw Unsliceable(
          "no end of the part was found for volumetric.target=tangent; expected a face of the surface that "
          "is farther from the bed, through the part, than all around",
          mesh_);
    std::vector<char> given = stands;
    std::vector<double> value(cells_.nodeCount(), 0.0);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (!ends[node].isZero() && given[node] == 0) {
        given[node] = 1;
        value[node] = 1.0;
      }
    const std::vector<double> field = harmonic(given, value);
    const std::vector<Point3> gradients = gradientsOf(field);
    // Where neighbours were too few for a gradient, there is only that of the arrival.
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node)
      if (gradients[node] == arrived_[node]) given[node] = 1;
    const std::vector<double> lengths = evenLengths({cells_, field, gradients, given});
    const double most = request_.limits.max_thickness;
    std::vector<Point3> along(cells_.nodeCount(), Point3::Zero());
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      const Point3& direction = ends[node].isZero() ? gradients[node] : ends[node];
      along[node] = std::clamp(lengths[node], 1.0 / most, most) * direction.normalized();
    }
    return along;
  }

  /// The field that has values at the nodes where they are given, and between them no sources.
  std::vector<double> harmonic(const std::vector<char>& given, const std::vector<double>& value) const {
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
    return {field.data(), field.data() + count};
  }

  /// Directions within the limits, of the length that growth is to have: their own along a part and as given,
  /// else that of the arrival.
  std::vector<Point3> wantedGradients(std::vector<Point3> directions, const std::vector<char>& foot) const {
    const bool is_along = request_.target == GrowthTarget::Tangent || request_.target == GrowthTarget::Given;
    std::vector<double> lengths(cells_.nodeCount(), 1.0);
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      if (!isReached(node)) continue;
      Point3& direction = directions[node];
      if (!(direction.norm() > 0.0)) direction = arrived_[node];
      lengths[node] = is_along ? direction.norm()
                               : std::clamp(arrived_[node].norm(), 1.0 / request_.limits.max_thickness, 1.0);
      direction.normalize();
    }
    const double deepest = -std::sin(request_.limits.overhang_rad);
    for (const SkinPart& part : skin_) {
      Point3& direction = directions[part.node];
      if (foot[part.node] == 0 && part.normal.dot(direction) < deepest)
        direction = atAngle(direction, part.normal, M_PI_2 + request_.limits.overhang_rad);
    }
    for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
      if (!isReached(node)) continue;
      Point3& direction = directions[node];
      if (direction.z() < std::cos(request_.limits.max_tilt_rad))
        direction = atAngle(direction, Point3::UnitZ(), request_.limits.max_tilt_rad);
      direction *= lengths[node];
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
