// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description_files/controller_entry.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimals.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kGreatestZero = 360.0;  // deg
constexpr double kLastTool = 32.0;
constexpr double kLastFrame = 64.0;

std::vector<double> sixFrom(const StrictYaml& node, double most, const char* expected) {
  std::vector<double> numbers = node.numbers();
  if (numbers.size() != 6)
    node.refuse("has " + std::to_string(numbers.size()) + " numbers; expected 6, one for each joint");
  for (const double number : numbers)
    if (!(std::abs(number) <= most)) node.refuse("holds " + numberText(number) + "; expected " + expected);
  return numbers;
}

double shareFrom(const StrictYaml& node) {
  const double share = node.number();
  if (!(std::abs(share) <= 1.0)) node.refuse("is " + numberText(share) + "; expected -1 to 1");
  return share;
}

int numberFrom(const StrictYaml& node, double last) {
  const double number = node.number();
  if (!(number >= 0.0 && number <= last) || number != std::round(number))
    node.refuse("is " + numberText(number) + "; expected a whole number, 0 to " + numberText(last));
  return static_cast<int>(number);
}

std::string kindFrom(const StrictYaml& node) {
  std::string kind = node.text();
  if (std::find(kControllerKinds.begin(), kControllerKinds.end(), kind) == kControllerKinds.end())
    node.refuse("is '" + kind + "'; expected abb, kuka, fanuc, yaskawa or ur");
  return kind;
}

std::string listedText(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + shortestText(number);
  return text;
}

}  // namespace

ArmController armControllerFrom(const StrictYaml& node) {
  ArmController controller;
  for (const auto& [key, value] :
       node.entries({"kind", "sign", "zero_deg", "j3_from_j2", "tool_number", "frame_number"})) {
    if (key == "kind") controller.kind = kindFrom(value);
    if (key == "sign") controller.signs = sixFrom(value, 1.0, "1 or -1");
    if (key == "zero_deg") controller.zeros_deg = sixFrom(value, kGreatestZero, "-360 to 360 deg");
    if (key == "j3_from_j2") controller.joint_3_from_2 = shareFrom(value);
    if (key == "tool_number") controller.tool_number = numberFrom(value, kLastTool);
    if (key == "frame_number") controller.frame_number = numberFrom(value, kLastFrame);
  }
  if (controller.kind.empty()) node.refuse("has no kind; expected abb, kuka, fanuc, yaskawa or ur");
  for (const double sign : controller.signs)
    if (std::abs(sign) != 1.0) node.refuse("has the sign " + numberText(sign) + "; expected 1 or -1");
  if (controller.joint_3_from_2 && controller.kind != "fanuc")
    node.refuse("has j3_from_j2 with kind '" + controller.kind + "'; expected it with fanuc alone");
  if (controller.kind == "kuka" && (controller.tool_number == 0 || controller.frame_number == 0))
    node.refuse("has a number of 0 with kind 'kuka'; expected 1 or more: TOOL_DATA and BASE_DATA have no 0");
  const bool is_mapped = !controller.signs.empty() || !controller.zeros_deg.empty() ||
                         controller.tool_number || controller.frame_number;
  if (controller.kind == "abb" && is_mapped)
    node.refuse(
        "has more than its kind with kind 'abb'; expected that alone: modules name their tool, and state "
        "joints "
        "as the description counts them");
  return controller;
}

std::string controllerText(const ArmController& controller) {
  std::string text = "<lamina_controller kind=\"" + controller.kind + "\"";
  const auto add = [&text](const char* attribute, const std::string& value) {
    if (!value.empty()) text += std::string(" ") + attribute + "=\"" + value + "\"";
  };
  add("sign", listedText(controller.signs));
  add("zero_deg", listedText(controller.zeros_deg));
  if (controller.joint_3_from_2) add("j3_from_j2", shortestText(*controller.joint_3_from_2));
  if (controller.tool_number) add("tool_number", std::to_string(*controller.tool_number));
  if (controller.frame_number) add("frame_number", std::to_string(*controller.frame_number));
  return text + "/>";
}

}  // namespace lamina
