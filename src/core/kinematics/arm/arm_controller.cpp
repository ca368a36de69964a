// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/arm/arm_controller.hpp"

#include <tinyxml.h>

#include <sstream>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::vector<double> listedNumbers(const TiXmlElement& element, const char* attribute) {
  const char* const text = element.Attribute(attribute);
  std::istringstream words(text == nullptr ? "" : text);
  std::vector<double> numbers;
  for (double number = 0.0; words >> number;) numbers.push_back(number);
  return numbers;
}

std::optional<int> wholeNumber(const TiXmlElement& element, const char* attribute) {
  int number = 0;
  if (element.QueryIntAttribute(attribute, &number) != TIXML_SUCCESS) return std::nullopt;
  return number;
}

}  // namespace

std::optional<ArmController> armController(const std::string& urdf) {
  TiXmlDocument document;
  document.Parse(urdf.c_str());
  const TiXmlElement* const root = document.RootElement();
  const TiXmlElement* const stated = root == nullptr ? nullptr : root->FirstChildElement("lamina_controller");
  if (stated == nullptr) return std::nullopt;
  ArmController controller;
  const char* const kind = stated->Attribute("kind");
  controller.kind = kind == nullptr ? "" : kind;
  controller.signs = listedNumbers(*stated, "sign");
  controller.zeros_deg = listedNumbers(*stated, "zero_deg");
  const std::vector<double> share = listedNumbers(*stated, "j3_from_j2");
  if (!share.empty()) controller.joint_3_from_2 = share.front();
  controller.tool_number = wholeNumber(*stated, "tool_number");
  controller.frame_number = wholeNumber(*stated, "frame_number");
  return controller;
}

void requireControllerKind(const std::string& urdf, const std::string& kind, const std::string& language) {
  const std::optional<ArmController> controller = armController(urdf);
  if (!controller || controller->kind == kind) return;
  throw InvalidConfig("the program is one in " + language + ", for a controller of kind '" + kind +
                      "', but cell.controller has the kind '" + controller->kind + "'; expected that kind");
}

}  // namespace lamina
