// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/cell_description.hpp"

#include <tinyxml.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/decimals.hpp"
#include "base/strict_yaml.hpp"
#include "kinematics/description_files/controller_entry.hpp"
#include "kinematics/description_files/description_faults.hpp"
#include "kinematics/description_files/flange.hpp"
#include "kinematics/description_files/replaced_limits.hpp"
#include "kinematics/model/link_motion.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/description_files/robot_description.hpp"

namespace lamina {
namespace {

constexpr double kMetre = 1e-3;  // in a millimetre
constexpr double kAcross = 0.5;  // cosine: the flange's z is neither along the last axis nor against it
constexpr double kHeaviestCellTool = 1000.0;  // kg
constexpr std::size_t kMostOfGantry = 3;
constexpr int kDigitsOfCell = 17;  // of doubles

using Vector = std::array<double, 3>;

/// Where something stands.
struct Placing {
  Vector xyz_mm{};
  Vector rpy_deg{};
};

struct CellTool {
  Placing at;
  std::string axis = "z";  // of its frame, along which the nozzle points
  std::vector<std::string> meshes;
  double mass_kg = 0.0;             // 0 if nothing is said
  std::optional<Vector> centre_mm;  // of gravity, in the frame of the flange
};

struct CellArm {
  std::string urdf;
  std::string base;
  std::string flange;
  std::optional<Vector> flange_turn_deg;
  std::vector<ReplacedLimit> limits;
};

struct CellAxis {
  Vector axis{};
  double lower_mm = 0.0;
  double upper_mm = 0.0;
  double speed_mm_s = 0.0;
};

struct CellPositioner {
  std::string urdf;
  std::string flange;
  Placing at;
};

struct CellBed {
  Placing at;
  std::array<double, 2> size_mm{};
};

struct CellBody {
  std::string mesh;
  Placing at;
};

struct CellFile {
  std::vector<std::string> packages;
  CellArm arm;
  std::vector<CellAxis> rails;  // those that carry the arm, from the room on
  std::optional<CellPositioner> positioner;
  CellTool tool;
  CellBed bed;
  std::optional<ArmController> controller;
  std::vector<CellBody> bodies;
  std::vector<std::array<std::string, 2>> ignored;  // links that are not checked against each other
};

Vector vectorFrom(const StrictYaml& node) {
  const std::vector<double> numbers = node.numbers();
  if (numbers.size() != 3) node.refuse("has " + std::to_string(numbers.size()) + " numbers; expected 3");
  return {numbers[0], numbers[1], numbers[2]};
}

/// Reads a cell file; paths over its folder.
class CellReader {
 public:
  explicit CellReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  CellFile read(const StrictYaml& document) const {
    const auto top = document.entries({"cell"});
    if (top.empty()) document.refuse("is empty; expected cell");
    CellFile cell;
    bool has_arm = false;
    bool has_bed = false;
    for (const auto& [key, node] : top[0].second.entries({"packages", "arm", "rail", "gantry", "positioner",
                                                          "tool", "bed", "bodies", "ignore", "controller"})) {
      if (key == "packages")
        for (const std::string& folder : node.texts()) cell.packages.push_back(placed(folder));
      if (key == "arm") cell.arm = arm(node);
      if (key == "rail" || key == "gantry") {
        if (!cell.rails.empty()) node.refuse("stands beside the other of rail and gantry; expected one");
        if (key == "rail") cell.rails.push_back(rail(node));
        if (key == "gantry") cell.rails = gantry(node);
      }
      if (key == "positioner") cell.positioner = positioner(node);
      if (key == "tool") cell.tool = tool(node);
      if (key == "controller") cell.controller = armControllerFrom(node);
      if (key == "bed") cell.bed = bed(node);
      if (key == "bodies")
        for (const StrictYaml& piece : node.pieces()) cell.bodies.push_back(body(piece));
      if (key == "ignore")
        for (const StrictYaml& piece : node.pieces()) cell.ignored.push_back(ignoredPair(piece));
      has_arm |= key == "arm";
      has_bed |= key == "bed";
    }
    if (!has_arm || !has_bed) top[0].second.refuse("lacks arm or bed; expected both");
    return cell;
  }

 private:
  std::string placed(const std::string& path) const { return (folder_ / path).lexically_normal().string(); }

  std::string mesh(const StrictYaml& node) const {
    std::string path = placed(node.text());
    if (!isMeshOfBodies(path)) node.refuse("is '" + node.text() + "'; expected STL, OBJ or PLY");
    if (!std::filesystem::exists(path)) node.refuse("is '" + node.text() + "', but there is no file " + path);
    return path;
  }

  CellArm arm(const StrictYaml& node) const {
    CellArm arm;
    for (const auto& [key, value] : node.entries({"urdf", "base", "flange", "flange_turn_deg", "limits"})) {
      if (key == "urdf") arm.urdf = placed(value.text());
      if (key == "base") arm.base = value.text();
      if (key == "flange") arm.flange = value.text();
      if (key == "flange_turn_deg") arm.flange_turn_deg = vectorFrom(value);
      if (key == "limits") arm.limits = replacedLimitsFrom(value);
    }
    if (arm.urdf.empty()) node.refuse("names no urdf; expected the file of the arm");
    return arm;
  }

  static std::array<std::string, 2> ignoredPair(const StrictYaml& node) {
    const std::vector<std::string> links = node.texts();
    if (links.size() != 2 || links[0] == links[1])
      node.refuse("names no two links; expected those that are not checked against each other");
    return {links[0], links[1]};
  }

  static CellAxis rail(const StrictYaml& node) {
    CellAxis rail;
    for (const auto& [key, value] : node.entries({"axis", "lower_mm", "upper_mm", "mm_s"})) {
      if (key == "axis") rail.axis = vectorFrom(value);
      if (key == "lower_mm") rail.lower_mm = value.number();
      if (key == "upper_mm") rail.upper_mm = value.number();
      if (key == "mm_s") rail.speed_mm_s = value.number();
    }
    if (!(rail.lower_mm < rail.upper_mm)) node.refuse("has a lower_mm that is not less than upper_mm");
    if (!(rail.speed_mm_s > 0.0)) node.refuse("has no mm_s; expected a positive speed");
    return rail;
  }

  static std::vector<CellAxis> gantry(const StrictYaml& node) {
    std::vector<CellAxis> axes;
    for (const StrictYaml& piece : node.pieces()) axes.push_back(rail(piece));
    if (axes.size() < 2 || axes.size() > kMostOfGantry)
      node.refuse("has " + std::to_string(axes.size()) + " axes; expected 2 or 3, or rail for one");
    return axes;
  }

  CellPositioner positioner(const StrictYaml& node) const {
    CellPositioner positioner;
    for (const auto& [key, value] : node.entries({"urdf", "flange", "xyz_mm", "rpy_deg"})) {
      if (key == "urdf") positioner.urdf = placed(value.text());
      if (key == "flange") positioner.flange = value.text();
      if (key == "xyz_mm") positioner.at.xyz_mm = vectorFrom(value);
      if (key == "rpy_deg") positioner.at.rpy_deg = vectorFrom(value);
    }
    if (positioner.urdf.empty()) node.refuse("names no urdf; expected the file of the positioner");
    return positioner;
  }

  CellTool tool(const StrictYaml& node) const {
    CellTool tool;
    // jet: the name of axis in the release before.
    for (const auto& [key, value] :
         node.entries({"xyz_mm", "rpy_deg", "axis", "bodies", "jet", "mass_kg", "centre_mm"})) {
      const bool is_axis = key == "axis" || key == "jet";
      if (key == "xyz_mm") tool.at.xyz_mm = vectorFrom(value);
      if (key == "rpy_deg") tool.at.rpy_deg = vectorFrom(value);
      if (is_axis) tool.axis = value.text();
      if (key == "mass_kg") tool.mass_kg = value.number();
      if (key == "centre_mm") tool.centre_mm = vectorFrom(value);
      if (key == "mass_kg" && !(tool.mass_kg > 0.0 && tool.mass_kg <= kHeaviestCellTool))
        value.refuse("is " + numberText(tool.mass_kg) + " kg; expected more than 0, 1000 kg at most");
      if (key == "bodies")
        for (const StrictYaml& piece : value.pieces()) tool.meshes.push_back(mesh(piece));
      if (is_axis && tool.axis != "x" && tool.axis != "y" && tool.axis != "z")
        value.refuse("is '" + tool.axis + "'; expected x, y or z");
    }
    if ((tool.mass_kg > 0.0) != tool.centre_mm.has_value())
      node.refuse("has one of mass_kg and centre_mm; expected both, or neither");
    return tool;
  }

  static CellBed bed(const StrictYaml& node) {
    CellBed bed;
    for (const auto& [key, value] : node.entries({"xyz_mm", "rpy_deg", "size_mm"})) {
      if (key == "xyz_mm") bed.at.xyz_mm = vectorFrom(value);
      if (key == "rpy_deg") bed.at.rpy_deg = vectorFrom(value);
      if (key != "size_mm") continue;
      const std::vector<double> size = value.numbers();
      if (size.size() != 2 || !(size[0] > 0.0) || !(size[1] > 0.0))
        value.refuse("is no size; expected two positive numbers");
      bed.size_mm = {size[0], size[1]};
    }
    if (!(bed.size_mm[0] > 0.0)) node.refuse("has no size_mm; expected that of the plate");
    return bed;
  }

  CellBody body(const StrictYaml& node) const {
    CellBody body;
    for (const auto& [key, value] : node.entries({"mesh", "xyz_mm", "rpy_deg"})) {
      if (key == "mesh") body.mesh = mesh(value);
      if (key == "xyz_mm") body.at.xyz_mm = vectorFrom(value);
      if (key == "rpy_deg") body.at.rpy_deg = vectorFrom(value);
    }
    if (body.mesh.empty()) node.refuse("names no mesh");
    return body;
  }

  std::filesystem::path folder_;
};

std::string numbersText(const Vector& numbers, double factor) {
  std::ostringstream text;
  text.precision(kDigitsOfCell);
  text << factor * numbers[0] << ' ' << factor * numbers[1] << ' ' << factor * numbers[2];
  return text.str();
}

std::string originText(const Placing& at) {
  return "<origin xyz=\"" + numbersText(at.xyz_mm, kMetre) + "\" rpy=\"" +
         numbersText(at.rpy_deg, toRadians(1.0)) + "\"/>";
}

std::string jointText(const std::string& name, const std::string& type,
                      const std::pair<std::string, std::string>& parent_and_child, const std::string& more) {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent_and_child.first +
         "\"/><child link=\"" + parent_and_child.second + "\"/>" + more + "</joint>";
}

constexpr char kCellMaterials[] =
    "<material name=\"cell_tool\"><color rgba=\"0.30 0.33 0.38 1\"/></material>"
    "<material name=\"cell_bed\"><color rgba=\"0.36 0.38 0.40 1\"/></material>"
    "<material name=\"cell_body\"><color rgba=\"0.75 0.72 0.62 1\"/></material>";

/// A body that is seen as it is.
std::string bodyText(const std::string& geometry, const Placing& at, const std::string& material) {
  const std::string shape = originText(at) + "<geometry>" + geometry + "</geometry>";
  return "<visual>" + shape + "<material name=\"" + material + "\"/></visual><collision>" + shape +
         "</collision>";
}

std::string meshText(const std::string& path, const Placing& at, const std::string& material) {
  return bodyText("<mesh filename=\"file://" + path + "\" scale=\"0.001 0.001 0.001\"/>", at, material);
}

/// The elements of a description, without its root.
std::string innerText(const std::string& urdf) {
  TiXmlDocument document;
  document.Parse(urdf.c_str());
  TiXmlPrinter printer;
  for (const TiXmlNode* node = document.RootElement()->FirstChild(); node != nullptr;
       node = node->NextSibling())
    if (node->ToElement() != nullptr) node->Accept(&printer);
  return printer.Str();
}

/// With the prefix that keeps names of a positioner apart from those of the arm.
void renameOfPositioner(TiXmlElement* element, const char* attribute) {
  if (element != nullptr) element->SetAttribute(attribute, "positioner_" + attributeOf(*element, attribute));
}

void renameLinksAndMaterials(TiXmlElement& robot) {
  for (TiXmlElement* material = robot.FirstChildElement("material"); material;
       material = material->NextSiblingElement("material"))
    renameOfPositioner(material, "name");
  for (TiXmlElement* link = robot.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    renameOfPositioner(link, "name");
    for (TiXmlElement* visual = link->FirstChildElement("visual"); visual;
         visual = visual->NextSiblingElement("visual"))
      renameOfPositioner(visual->FirstChildElement("material"), "name");
  }
}

/// The joints of a positioner that a motor drives, from its root outward: their elements stand in any order.
std::vector<std::string> drivenOutward(const urdf::ModelInterface& positioner) {
  std::vector<std::pair<int, std::string>> by_depth;
  for (const auto& [name, joint] : positioner.joints_) {
    if (joint->type == urdf::Joint::FIXED || joint->mimic) continue;
    int depth = 0;
    for (auto link = positioner.getLink(joint->parent_link_name); link->parent_joint;
         link = link->getParent())
      ++depth;
    by_depth.emplace_back(depth, name);
  }
  std::sort(by_depth.begin(), by_depth.end());
  std::vector<std::string> names;
  names.reserve(by_depth.size());
  for (auto& [depth, name] : by_depth) names.push_back(std::move(name));
  return names;
}

/// A positioner's description, its links, materials and joints with a prefix, its driven joints as external
/// axes.
std::string positionerText(const std::string& urdf, const std::string& path, int first_external) {
  const std::vector<std::string> driven = drivenOutward(*parseMachine(urdf));
  if (driven.empty() || driven.size() > 2)
    throw InvalidConfig("positioner " + path + " has " + std::to_string(driven.size()) +
                        " driven joints; expected one or two");
  const auto renameJoint = [&](TiXmlElement* element, const char* attribute) {
    const auto at = std::find(driven.begin(), driven.end(), attributeOf(*element, attribute));
    if (at == driven.end()) return renameOfPositioner(element, attribute);
    element->SetAttribute(attribute,
                          "external_" + std::to_string(first_external + std::distance(driven.begin(), at)));
  };
  TiXmlDocument document;
  document.Parse(urdf.c_str());
  TiXmlElement* robot = document.RootElement();
  renameLinksAndMaterials(*robot);
  for (TiXmlElement* joint = robot->FirstChildElement("joint"); joint;
       joint = joint->NextSiblingElement("joint")) {
    renameOfPositioner(joint->FirstChildElement("parent"), "link");
    renameOfPositioner(joint->FirstChildElement("child"), "link");
    renameJoint(joint, "name");
    if (TiXmlElement* mimic = joint->FirstChildElement("mimic")) renameJoint(mimic, "joint");
  }
  TiXmlPrinter printer;
  document.Accept(&printer);
  return printer.Str();
}

/// As a description states what a link weighs; its inertia is not known.
std::string loadText(const CellTool& tool) {
  if (tool.mass_kg == 0.0) return "";
  return "<inertial>" + originText({*tool.centre_mm, {}}) + "<mass value=\"" + shortestText(tool.mass_kg) +
         "\"/><inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial>";
}

std::string toolText(const CellFile& cell, const std::string& flange) {
  const Placing turn{{}, cell.arm.flange_turn_deg.value_or(Vector{})};
  Placing axis;
  if (cell.tool.axis == "x") axis.rpy_deg = {0.0, 90.0, 0.0};
  if (cell.tool.axis == "y") axis.rpy_deg = {-90.0, 0.0, 0.0};
  std::string bodies;
  for (const std::string& mesh : cell.tool.meshes) bodies += meshText(mesh, {}, "cell_tool");
  return "<link name=\"cell_flange\">" + loadText(cell.tool) + bodies +
         "</link><link name=\"cell_tool\"/><link name=\"nozzle\"/>" +
         jointText("cell_flange_turn", "fixed", {flange, "cell_flange"}, originText(turn)) +
         jointText("cell_tool_place", "fixed", {"cell_flange", "cell_tool"}, originText(cell.tool.at)) +
         jointText("cell_tool_axis", "fixed", {"cell_tool", "nozzle"}, originText(axis));
}

std::string bedText(const CellFile& cell, const std::string& parent) {
  constexpr double kThick = 20.0;  // mm
  const std::string plate =
      "<box size=\"" + numbersText({cell.bed.size_mm[0], cell.bed.size_mm[1], kThick}, kMetre) + "\"/>";
  return "<link name=\"bed\">" + bodyText(plate, {{0.0, 0.0, -0.5 * kThick}, {}}, "cell_bed") + "</link>" +
         jointText("cell_bed_place", "fixed", {parent, "bed"}, originText(cell.bed.at));
}

std::string axisText(const CellAxis& rail, const std::string& name,
                     const std::pair<std::string, std::string>& parent_and_child) {
  std::ostringstream limit;
  limit.precision(kDigitsOfCell);
  limit << "<limit lower=\"" << kMetre * rail.lower_mm << "\" upper=\"" << kMetre * rail.upper_mm
        << "\" velocity=\"" << kMetre * rail.speed_mm_s << "\" effort=\"0\"/>";
  return jointText(name, "prismatic", parent_and_child,
                   "<axis xyz=\"" + numbersText(rail.axis, 1.0) + "\"/>" + limit.str());
}

/// What carries the arm: each axis of a gantry moves a carriage, the last one the arm.
std::string railText(const CellFile& cell, const std::string& root) {
  if (cell.rails.empty()) return jointText("cell_arm_place", "fixed", {"cell_world", root}, originText({}));
  std::string text;
  std::string under = "cell_world";
  for (std::size_t i = 0; i < cell.rails.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    const bool is_last = i + 1 == cell.rails.size();
    const std::string moved = is_last ? root : "cell_carriage_" + number;
    if (!is_last) text += "<link name=\"" + moved + "\"/>";
    text += axisText(cell.rails[i], "external_" + number, {under, moved});
    under = moved;
  }
  return text;
}

/// The base of the arm, in which the bed is placed: it stands still where the arm stands with its rail at
/// zero.
std::string baseText(const urdf::ModelInterface& arm, const std::string& base) {
  Eigen::Isometry3d root_from_base = Eigen::Isometry3d::Identity();
  for (const urdf::Link* link = &requireLink(arm, base); link->parent_joint;
       link = &requireLink(arm, link->parent_joint->parent_link_name))
    root_from_base = poseOf(link->parent_joint->parent_to_joint_origin_transform) * root_from_base;
  const Point3 at = root_from_base.translation();
  const Eigen::Matrix3d& r = root_from_base.linear();
  const Vector rpy = {std::atan2(r(2, 1), r(2, 2)), -std::asin(std::clamp(r(2, 0), -1.0, 1.0)),
                      std::atan2(r(1, 0), r(0, 0))};
  const Placing placing{{at.x(), at.y(), at.z()}, {toDegrees(rpy[0]), toDegrees(rpy[1]), toDegrees(rpy[2])}};
  return "<link name=\"cell_base\"/>" +
         jointText("cell_base_place", "fixed", {"cell_world", "cell_base"}, originText(placing));
}

std::string mergedText(const CellFile& cell) {
  const std::string arm_text =
      robotDescription(withReplacedLimits(readFile(cell.arm.urdf, kMostSettingsBytes), cell.arm.limits),
                       cell.arm.urdf, cell.packages);
  const auto arm = parseMachine(arm_text);
  const std::string flange = flangeOf(*arm, cell.arm.flange);
  if (!cell.arm.base.empty()) requireLink(*arm, cell.arm.base);
  const Eigen::Vector3d axis = flangeAxis(*arm, flange);
  if (std::abs(axis.z()) < kAcross && !cell.arm.flange_turn_deg)
    throw InvalidConfig("arm '" + arm->getName() + "': z of link '" + flange +
                        "' lies across the last axis; expected cell.arm.flange_turn_deg, by which it is "
                        "turned: " +
                        flangeTurns(axis));
  std::string text = "<robot name=\"" + arm->getName() + "\">" + kCellMaterials +
                     "<link name=\"cell_world\"/>" + innerText(arm_text) +
                     railText(cell, arm->getRoot()->name) + toolText(cell, flange);
  std::string under_bed = cell.arm.base.empty() ? "cell_world" : "cell_base";
  if (!cell.arm.base.empty()) text += baseText(*arm, cell.arm.base);
  if (cell.positioner) {
    const std::string& path = cell.positioner->urdf;
    const std::string moved = positionerText(readRobotDescription(path, cell.packages), path,
                                             static_cast<int>(cell.rails.size()) + 1);
    const auto table = parseMachine(moved);
    const std::string carried =
        flangeOf(*table, cell.positioner->flange.empty() ? "" : "positioner_" + cell.positioner->flange);
    text +=
        innerText(moved) + jointText("cell_positioner_place", "fixed", {under_bed, table->getRoot()->name},
                                     originText(cell.positioner->at));
    under_bed = carried;
  }
  text += bedText(cell, under_bed);
  if (!cell.bodies.empty()) {
    text += "<link name=\"cell_bodies\">";
    for (const CellBody& body : cell.bodies) text += meshText(body.mesh, body.at, "cell_body");
    text +=
        "</link>" + jointText("cell_bodies_place", "fixed", {"cell_world", "cell_bodies"}, originText({}));
  }
  if (cell.controller) text += controllerText(*cell.controller);
  for (const auto& [one, other] : cell.ignored)
    text += "<lamina_ignore link1=\"" + one + "\" link2=\"" + other + "\"/>";
  return text + "</robot>";
}

}  // namespace

std::string cellDescription(const std::string& text, const std::string& path) {
  try {
    const CellReader reader(std::filesystem::absolute(path).parent_path());
    return robotDescription(mergedText(reader.read(StrictYaml(YAML::Load(text), path, ""))), path);
  } catch (const YAML::Exception& error) {
    throw InvalidConfig(path + ", line " + std::to_string(error.mark.line + 1) + ": " + error.msg);
  }
}

bool isCellFile(const std::string& path) {
  const std::string suffix = std::filesystem::path(path).extension();
  return suffix == ".yaml" || suffix == ".yml";
}

bool holdsCell(const std::string& path) {
  if (!isCellFile(path)) return false;
  try {
    const YAML::Node document = YAML::Load(readFile(path, kMostSettingsBytes));
    return document.IsMap() && document["cell"].IsDefined();
  } catch (const YAML::Exception&) {
    return false;
  } catch (const Error&) {
    return false;
  }
}

std::string readMachineDescription(const std::string& path) {
  return isCellFile(path) ? cellDescription(readFile(path, kMostSettingsBytes), path)
                          : readRobotDescription(path);
}

}  // namespace lamina
