// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Bodies of triangles in random poses of arms, against tests of each triangle with each: of the example with
// meshes, and of the descriptions (.yaml cell files, .urdf) that LAMINA_MESH_ARMS names, with colons between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <numeric>
#include <sstream>

#include "lamina/base/random.hpp"
#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "support/arms.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {
namespace {

using Corners = std::array<Point3, 3>;

/// Whether no plane across a direction has one triangle on either side.
bool overlapAlong(const Corners& a, const Corners& b, const Point3& direction) {
  const auto span = [&](const Corners& corners) {
    const std::array<double, 3> at = {corners[0].dot(direction), corners[1].dot(direction),
                                      corners[2].dot(direction)};
    return std::minmax({at[0], at[1], at[2]});
  };
  const auto [low_a, high_a] = span(a);
  const auto [low_b, high_b] = span(b);
  return low_a <= high_b && low_b <= high_a;
}

/// Two triangles are apart exactly if a plane lies between them, across a normal, the product of two edges,
/// or an edge turned within its triangle's plane.
bool trianglesMeet(const Corners& a, const Corners& b) {
  const auto edge = [](const Corners& corners, std::size_t i) -> Point3 {
    return corners[(i + 1) % 3] - corners[i];
  };
  const Point3 normal_a = edge(a, 0).cross(edge(a, 1));
  const Point3 normal_b = edge(b, 0).cross(edge(b, 1));
  if (!overlapAlong(a, b, normal_a) || !overlapAlong(a, b, normal_b)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!overlapAlong(a, b, normal_a.cross(edge(a, i))) || !overlapAlong(a, b, normal_b.cross(edge(b, i))))
      return false;
    for (std::size_t j = 0; j < 3; ++j)
      if (!overlapAlong(a, b, edge(a, i).cross(edge(b, j)))) return false;
  }
  return true;
}

/// The triangles of a body where it stands.
struct PlacedTriangles {
  std::vector<Point3> vertices;
  std::vector<Corners> triangles;
  Box3 bounds;
};

Box3 boundsOf(const Corners& corners) {
  return {corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
          corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])};
}

bool areApart(const Box3& a, const Box3& b) {
  return (a.low.array() > b.high.array()).any() || (b.low.array() > a.high.array()).any();
}

PlacedTriangles placed(const Mesh& mesh, const Eigen::Isometry3d& pose) {
  PlacedTriangles body;
  body.vertices.reserve(mesh.vertices.size());
  for (const Point3& vertex : mesh.vertices) body.vertices.push_back(pose * vertex);
  body.bounds = {body.vertices.front(), body.vertices.front()};
  for (const Point3& vertex : body.vertices) {
    body.bounds.low = body.bounds.low.cwiseMin(vertex);
    body.bounds.high = body.bounds.high.cwiseMax(vertex);
  }
  body.triangles.reserve(mesh.triangles.size());
  for (const Triangle& each : mesh.triangles)
    body.triangles.push_back({body.vertices[each[0]], body.vertices[each[1]], body.vertices[each[2]]});
  return body;
}

std::vector<Corners> near(const PlacedTriangles& body, const Box3& region) {
  std::vector<Corners> found;
  for (const Corners& corners : body.triangles)
    if (!areApart(boundsOf(corners), region)) found.push_back(corners);
  return found;
}

bool surfacesMeet(const PlacedTriangles& a, const PlacedTriangles& b) {
  if (areApart(a.bounds, b.bounds)) return false;
  const std::vector<Corners> of_b = near(b, a.bounds);
  for (const Corners& one : near(a, b.bounds)) {
    const Box3 bounds = boundsOf(one);
    for (const Corners& other : of_b)
      if (!areApart(bounds, boundsOf(other)) && trianglesMeet(one, other)) return true;
  }
  return false;
}

/// How often the triangles go round a point, as the sum of the solid angles under which it sees them.
double turnsAbout(const PlacedTriangles& body, const Point3& point) {
  double angle = 0.0;
  for (const Corners& corners : body.triangles) {
    const Point3 a = (corners[0] - point).normalized();
    const Point3 b = (corners[1] - point).normalized();
    const Point3 c = (corners[2] - point).normalized();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return angle / (4.0 * M_PI);
}

/// Whether any vertex of one is within the other.
bool swallowed(const PlacedTriangles& outer, const PlacedTriangles& inner) {
  const auto isWithin = [&](const Point3& vertex) {
    return !areApart(outer.bounds, {vertex, vertex}) && std::abs(turnsAbout(outer, vertex)) > 0.5;
  };
  return std::any_of(inner.vertices.begin(), inner.vertices.end(), isWithin);
}

struct CheckedBody {
  const LinkBody* body = nullptr;
  std::unique_ptr<Solid> exact;
  std::unique_ptr<Solid> hull;
  const Mesh* mesh = nullptr;
};

/// Bodies of meshes, by group.
std::vector<std::vector<CheckedBody>> meshesOf(const LinkBodies& bodies) {
  std::vector<std::vector<CheckedBody>> groups(bodies.groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const LinkBody& body : bodies.groups[g].bodies)
      if (const auto* shape = std::get_if<MeshShape>(&body.shape))
        groups[g].push_back({&body, std::make_unique<Solid>(body.shape),
                             std::make_unique<Solid>(grown(body.shape, 0.0)), shape->mesh.get()});
  return groups;
}

struct Verdicts {
  int pairs = 0;
  int met = 0;
  int swallowed = 0;
};

/// Each pair of bodies in one pose: of the solids, of their hulls, and of each triangle with each.
void compare(const CheckedBody& a, const Eigen::Isometry3d& pose_a, const CheckedBody& b,
             const Eigen::Isometry3d& pose_b, Verdicts& verdicts) {
  const bool meets = a.exact->meets(*b.exact, pose_b, pose_a);
  const PlacedTriangles placed_a = placed(*a.mesh, pose_a);
  const PlacedTriangles placed_b = placed(*b.mesh, pose_b);
  const bool surfaces = surfacesMeet(placed_a, placed_b);
  ++verdicts.pairs;
  verdicts.met += meets ? 1 : 0;
  const std::string links = a.body->link + " " + b.body->link;
  if (surfaces) {
    EXPECT_TRUE(meets) << links;
    EXPECT_TRUE(a.hull->meets(*b.hull, pose_b, pose_a)) << links;
  } else if (meets) {
    ++verdicts.swallowed;
    EXPECT_TRUE(swallowed(placed_a, placed_b) || swallowed(placed_b, placed_a)) << links;
  }
}

Verdicts compareArm(const std::string& file, int poses) {
  const auto model = kinematicModelFromUrdf(readMachineDescription(file));
  const LinkBodies bodies = linkBodies(model->urdf());
  const auto groups = meshesOf(bodies);
  Random random(20261120);
  Verdicts verdicts;
  for (int i = 0; i < poses && !testing::Test::HasFailure(); ++i) {
    const auto links = model->bedFromLinks(test::anyJointValues(*model, random));
    for (const auto& [one, other] : bodies.pairs)
      for (const CheckedBody& a : groups[one])
        for (const CheckedBody& b : groups[other]) {
          if (areUnchecked(bodies, a.body->link, b.body->link)) continue;
          compare(a, links.at(a.body->link) * a.body->link_from_body, b,
                  links.at(b.body->link) * b.body->link_from_body, verdicts);
        }
  }
  return verdicts;
}

TEST(MeshBodies, OfTheExampleMeetWhereTheirTrianglesDo) {
  const Verdicts verdicts =
      compareArm(std::string(LAMINA_SOURCE_DIR) + "/examples/robots/tilting_cell/cell.yaml", 200);
  EXPECT_GT(verdicts.met, 50);
  EXPECT_GT(verdicts.pairs - verdicts.met, 500);
}

TEST(MeshBodies, OfNamedArmsMeetWhereTheirTrianglesDo) {
  const char* named = std::getenv("LAMINA_MESH_ARMS");
  if (named == nullptr) GTEST_SKIP() << "LAMINA_MESH_ARMS names no arms";
  std::istringstream files(named);
  for (std::string file; std::getline(files, file, ':');) {
    const Verdicts verdicts = compareArm(file, 1000);
    EXPECT_GT(verdicts.pairs, 0) << file;
    std::cout << file << ": " << verdicts.pairs << " pairs, " << verdicts.met << " meet, of which "
              << verdicts.swallowed << " one within the other\n";
  }
}

}  // namespace
}  // namespace lamina
