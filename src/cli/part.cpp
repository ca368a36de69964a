// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

struct PartOptions {
  std::string name;
  std::vector<std::string> assignments;
  std::string output;
  bool lists = false;
};

nlohmann::json partsAsJson() {
  nlohmann::json parts;
  for (const std::string& name : partNames()) {
    nlohmann::json parameters;
    for (const PartParameter& parameter : partParameters(name))
      parameters[parameter.key] = {
          {"default", parameter.default_value}, {"bounds", parameter.bounds}, {"meaning", parameter.meaning}};
    parts[name] = {{"meaning", partMeaning(name)}, {"parameters", parameters}};
  }
  return {{"parts", parts}};
}

void listParts(OutputFormat format) {
  if (format == OutputFormat::Json) {
    std::printf("%s\n", partsAsJson().dump().c_str());
    return;
  }
  for (const std::string& name : partNames()) {
    std::printf("%s: %s\n", name.c_str(), partMeaning(name).c_str());
    for (const PartParameter& parameter : partParameters(name))
      std::printf("  %-16s %-8s %-12s %s\n", parameter.key.c_str(), parameter.default_value.c_str(),
                  parameter.bounds.c_str(), parameter.meaning.c_str());
  }
}

void makeAndWrite(const PartOptions& options, OutputFormat format) {
  if (options.name.empty()) throw InvalidConfig("no part named; 'lamina part --list' names them");
  if (options.output.empty()) throw InvalidConfig("no output named; expected -o FILE.stl");
  if (std::filesystem::path(options.output).extension() != ".stl")
    throw InvalidConfig("output is '" + options.output + "'; its suffix must be .stl");
  const Mesh mesh = makePart(options.name, overridesFrom(options.assignments));
  writeStl(options.output, mesh);
  const Point3 size = boundingBox(mesh).size();
  if (format == OutputFormat::Json) {
    const nlohmann::json result = {{"part", options.name},
                                   {"output", options.output},
                                   {"triangles", mesh.triangles.size()},
                                   {"vertices", mesh.vertices.size()},
                                   {"volume_mm3", volume(mesh)},
                                   {"area_mm2", surfaceArea(mesh)},
                                   {"size_mm", {size.x(), size.y(), size.z()}}};
    std::printf("%s\n", result.dump().c_str());
    return;
  }
  std::printf("%s: %s, %zu triangles, %.4g x %.4g x %.4g mm, %.6g mm3\n", options.output.c_str(),
              options.name.c_str(), mesh.triangles.size(), size.x(), size.y(), size.z(), volume(mesh));
}

}  // namespace

void addPart(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand("part", "Write a parametric part as binary STL");
  const auto options = std::make_shared<PartOptions>();
  subcommand->add_option("name", options->name, "The part; --list names them");
  subcommand->add_option("--set", options->assignments, "A parameter as key=value; may be repeated")
      ->allow_extra_args(false);
  subcommand->add_option("-o,--output", options->output, "The STL file to write");
  subcommand->add_flag("--list", options->lists, "List parts and parameters instead");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([&chosen, options] {
    chosen.run = [&chosen, options] {
      options->lists ? listParts(chosen.format) : makeAndWrite(*options, chosen.format);
    };
  });
}

}  // namespace lamina::cli
