// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <nlohmann/json.hpp>

#include "lamina/base/error.hpp"
#include "lamina/gcode_rewrite/space_map.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/output_files.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

struct RotateArguments {
  std::string part;
  std::string output;
  double angle_deg = -45.0;
  std::string axis = "x";
};

/// Rotated about the origin and put on z = 0.
Mesh rotated(Mesh mesh, const RotateArguments& arguments) {
  const AffineMap turn = rotation(Point3::Unit(arguments.axis[0] - 'x'), arguments.angle_deg);
  for (Point3& vertex : mesh.vertices) vertex = turn.map(vertex);
  const double low = boundingBox(mesh).low.z();
  for (Point3& vertex : mesh.vertices) vertex.z() -= low;
  return mesh;
}

void rotate(const RotateArguments& arguments, OutputFormat format) {
  if (arguments.output.empty()) throw InvalidConfig("no output named; expected -o FILE.stl");
  requireSuffix(arguments.output, {".stl"});
  requireApart({arguments.output}, {arguments.part});
  const Mesh mesh =
      rotated(isPartName(arguments.part) ? makePart(arguments.part) : readMesh(arguments.part), arguments);
  writeStl(arguments.output, mesh);
  const Point3 size = boundingBox(mesh).size();
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json result = {{"part", arguments.part},
                                           {"output", arguments.output},
                                           {"triangles", mesh.triangles.size()},
                                           {"size_mm", {size.x(), size.y(), size.z()}}};
    std::printf("%s\n", result.dump().c_str());
    return;
  }
  std::printf("%s: %s rotated by %g deg about %s, %.4g x %.4g x %.4g mm\n", arguments.output.c_str(),
              arguments.part.c_str(), arguments.angle_deg, arguments.axis.c_str(), size.x(), size.y(),
              size.z());
}

}  // namespace

void addRotate(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "rotate", "Rotate a mesh about an axis and put it on the bed, as before planar slicing for `incline`");
  subcommand->alias("turn");  // the name of the release before
  const auto arguments = std::make_shared<RotateArguments>();
  subcommand->add_option("part", arguments->part, "Mesh file, or name of a parametric part")->required();
  subcommand->add_option("-o,--output", arguments->output, "The STL file to write");
  subcommand->add_option("--angle-deg", arguments->angle_deg, "Right-handed: -45")
      ->check(CLI::Range(-360.0, 360.0));
  subcommand->add_option("--axis", arguments->axis, "x, y or z: x")->check(CLI::IsMember({"x", "y", "z"}));
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { rotate(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
