// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/xacro_expansion.hpp"

#include <tinyxml.h>

#include <filesystem>
#include <memory>
#include <sstream>

#include "kinematics/description_files/description_faults.hpp"
#include "kinematics/description_files/package_path.hpp"
#include "kinematics/description_files/xacro_expression.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"

namespace lamina {
namespace {

constexpr int kMostNested = 100;  // files, macros and blocks within each other

/// A macro, as it stands in its file.
struct XacroMacro {
  const TiXmlElement* element = nullptr;
  std::string file;
};

/// Names within a macro, over those around it.
struct XacroFrame {
  std::map<std::string, XacroValue> properties;
  std::map<std::string, std::string> faults;  ///< of properties without value: reported where they are used
  std::map<std::string, std::vector<const TiXmlElement*>> blocks;
  const XacroFrame* around = nullptr;
};

std::string plainName(const std::string& tag) {
  const std::string prefix = "xacro:";
  return tag.rfind(prefix, 0) == 0 ? tag.substr(prefix.size()) : "";
}

/// The parameters of a macro: at blanks, but for those between quotes or within a substitution.
std::vector<std::string> parametersOf(const std::string& text) {
  std::vector<std::string> parameters;
  std::string parameter;
  bool is_quoted = false;
  int depth = 0;
  for (const char c : text + ' ') {
    if (c == '\'') is_quoted = !is_quoted;
    if (!is_quoted && (c == '(' || c == '{')) ++depth;
    if (!is_quoted && (c == ')' || c == '}')) --depth;
    const bool is_blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!is_blank || is_quoted || depth > 0) {
      parameter += c;
      continue;
    }
    if (!parameter.empty()) parameters.push_back(parameter);
    parameter.clear();
  }
  return parameters;
}

class Expansion {
 public:
  Expansion(const std::string& path, const std::map<std::string, std::string>& arguments,
            const std::vector<std::string>& packages)
      : packages_(packages), arguments_(arguments), file_(path) {}

  std::string run() {
    const TiXmlElement& source = parsed(file_);
    XacroFrame global;
    TiXmlDocument result;
    result.LinkEndChild(new TiXmlDeclaration("1.0", "", ""));  // NOLINT(cppcoreguidelines-owning-memory)
    auto robot = std::make_unique<TiXmlElement>("robot");
    for (const TiXmlAttribute* each = source.FirstAttribute(); each != nullptr; each = each->Next())
      if (std::string(each->Name()).rfind("xmlns", 0) != 0)
        robot->SetAttribute(each->Name(), substituted(each->Value(), global, source));
    expandChildren(source, *robot, global);
    result.LinkEndChild(robot.release());
    TiXmlPrinter printer;
    result.Accept(&printer);
    return printer.Str();
  }

 private:
  [[noreturn]] void refuse(const TiXmlElement& at, const std::string& what) const {
    throw InvalidConfig(file_ + ", line " + std::to_string(at.Row()) + ": " + what);
  }

  const TiXmlElement& parsed(const std::string& path) {
    auto document = std::make_unique<TiXmlDocument>();
    document->Parse(readFile(path, kMostSettingsBytes).c_str());
    if (document->Error() || document->RootElement() == nullptr ||
        std::string(document->RootElement()->Value()) != "robot")
      throw InvalidConfig(path + ", line " + std::to_string(document->ErrorRow()) +
                          ": is no xacro; expected XML whose root is <robot>");
    documents_.push_back(std::move(document));
    return *documents_.back()->RootElement();
  }

  static std::optional<XacroValue> property(const XacroFrame& frame, const std::string& name) {
    for (const XacroFrame* at = &frame; at != nullptr; at = at->around) {
      const auto found = at->properties.find(name);
      if (found != at->properties.end()) return found->second;
      const auto fault = at->faults.find(name);
      if (fault != at->faults.end())
        throw InvalidConfig("property '" + name + "' has no value: " + fault->second);
    }
    return std::nullopt;
  }

  XacroValue evaluate(const std::string& expression, const XacroFrame& frame, const TiXmlElement& at) {
    const XacroScope scope{[&](const std::string& name) { return property(frame, name); },
                           [&](const std::string& path) {
                             const std::string place = placed(path);
                             if (!std::filesystem::is_regular_file(place))
                               throw InvalidConfig("load_yaml names " + place + ", which is no file");
                             return YAML::Load(readFile(place, kMostSettingsBytes));
                           }};
    try {
      return evaluated(expression, scope);
    } catch (const InvalidConfig& error) {
      refuse(at, error.what());
    } catch (const YAML::Exception&) {
      refuse(at, "a YAML file cannot be read");
    }
  }

  std::string placed(const std::string& path) const {
    return (std::filesystem::path(file_).parent_path() / path).lexically_normal().string();
  }

  /// `$(find NAME)` and `$(arg NAME)`.
  std::string command(const std::string& text, const XacroFrame& frame, const TiXmlElement& at) {
    std::istringstream words(substituted(text, frame, at));
    std::string verb;
    std::string name;
    words >> verb >> name;
    if (verb == "arg") {
      const auto found = arguments_.find(name);
      if (found == arguments_.end())
        refuse(at, "argument '" + name + "' has no value; expected " + name + ":=VALUE");
      return found->second;
    }
    if (verb != "find") refuse(at, "$(" + verb + ") is not understood; expected $(find) or $(arg)");
    const PackagePath searched(packages_, file_);
    const auto folder = searched.package(name);
    if (!folder) refuse(at, "package '" + name + "' is not found");
    return *folder;
  }

  /// A text whose whole is one expression keeps its kind.
  XacroValue valueOf(const std::string& text, const XacroFrame& frame, const TiXmlElement& at) {
    const bool is_one = text.rfind("${", 0) == 0 && text.find('}') == text.size() - 1;
    if (is_one) return evaluate(text.substr(2, text.size() - 3), frame, at);
    return valueOfText(substituted(text, frame, at));
  }

  std::string substituted(const std::string& text, const XacroFrame& frame, const TiXmlElement& at) {
    std::string result;
    std::size_t i = 0;
    while (i < text.size()) {
      const bool opens = text[i] == '$' && i + 1 < text.size() && (text[i + 1] == '{' || text[i + 1] == '(');
      if (!opens) {
        result += text[i++];
        continue;
      }
      const bool is_expression = text[i + 1] == '{';
      const std::size_t end = text.find(is_expression ? '}' : ')', i);
      if (end == std::string::npos) refuse(at, "a substitution has no end");
      const std::string inner = text.substr(i + 2, end - i - 2);
      result += is_expression ? textOf(evaluate(inner, frame, at)) : command(inner, frame, at);
      i = end + 1;
    }
    return result;
  }

  void expandChildren(const TiXmlElement& source, TiXmlElement& into, XacroFrame& frame) {
    if (++depth_ > kMostNested)
      refuse(source, "is nested more than " + std::to_string(kMostNested) + " deep");
    for (const TiXmlNode* node = source.FirstChild(); node != nullptr; node = node->NextSibling()) {
      if (const TiXmlElement* element = node->ToElement())
        expand(*element, into, frame);
      else if (const TiXmlText* text = node->ToText())
        into.LinkEndChild(
            std::make_unique<TiXmlText>(substituted(text->ValueStr(), frame, source).c_str()).release());
    }
    --depth_;
  }

  void expand(const TiXmlElement& element, TiXmlElement& into, XacroFrame& frame) {
    const std::string name = plainName(element.Value());
    if (name.empty()) return copy(element, into, frame);
    if (name == "include") return include(element, into, frame);
    if (name == "property") return setProperty(element, frame);
    if (name == "arg") {
      arguments_.emplace(attributeOf(element, "name"),
                         substituted(attributeOf(element, "default"), frame, element));
      return;
    }
    if (name == "macro") {
      macros_[plainMacro(attributeOf(element, "name"))] = {&element, file_};
      return;
    }
    if (name == "if" || name == "unless") {
      if (isTrue(valueOf(attributeOf(element, "value"), frame, element)) == (name == "if"))
        expandChildren(element, into, frame);
      return;
    }
    if (name == "insert_block") return insertBlock(element, into, frame);
    const auto macro = macros_.find(name);
    if (macro == macros_.end()) refuse(element, "<xacro:" + name + "> is not understood, and no macro");
    call(macro->second, element, into, frame);
  }

  static std::string plainMacro(const std::string& name) {
    const std::string plain = plainName(name);
    return plain.empty() ? name : plain;
  }

  void copy(const TiXmlElement& element, TiXmlElement& into, XacroFrame& frame) {
    auto made = std::make_unique<TiXmlElement>(element.Value());
    for (const TiXmlAttribute* each = element.FirstAttribute(); each != nullptr; each = each->Next())
      made->SetAttribute(each->Name(), substituted(each->Value(), frame, element));
    expandChildren(element, *made, frame);
    into.LinkEndChild(made.release());
  }

  void include(const TiXmlElement& element, TiXmlElement& into, XacroFrame& frame) {
    const std::string before = file_;
    const std::string path = placed(substituted(attributeOf(element, "filename"), frame, element));
    const TiXmlElement& root = parsed(path);
    file_ = path;
    expandChildren(root, into, frame);
    file_ = before;
  }

  void setProperty(const TiXmlElement& element, XacroFrame& frame) {
    const std::string name = attributeOf(element, "name");
    const char* value = element.Attribute("value");
    const bool has_default = element.Attribute("default") != nullptr;
    if (has_default && property(frame, name)) return;
    if (value == nullptr && !has_default) {
      std::vector<const TiXmlElement*>& block = frame.blocks[name];
      for (const TiXmlElement* each = element.FirstChildElement(); each != nullptr;
           each = each->NextSiblingElement())
        block.push_back(each);
      return;
    }
    const bool is_outer = !attributeOf(element, "scope").empty() && frame.around != nullptr;
    XacroFrame& target = is_outer ? const_cast<XacroFrame&>(*frame.around) : frame;  // NOLINT
    try {
      const XacroValue set =
          valueOf(value != nullptr ? value : attributeOf(element, "default"), frame, element);
      target.properties.erase(name);  // a node of a YAML file that is assigned changes the file's
      target.properties.emplace(name, set);
    } catch (const InvalidConfig& error) {
      target.properties.erase(name);
      target.faults[name] = error.what();
    }
  }

  void insertBlock(const TiXmlElement& element, TiXmlElement& into, XacroFrame& frame) {
    const std::string name = attributeOf(element, "name");
    for (const XacroFrame* at = &frame; at != nullptr; at = at->around) {
      const auto found = at->blocks.find(name);
      if (found == at->blocks.end()) continue;
      for (const TiXmlElement* block : found->second) expand(*block, into, frame);
      return;
    }
    refuse(element, "there is no block '" + name + "'");
  }

  void call(const XacroMacro& macro, const TiXmlElement& element, TiXmlElement& into, XacroFrame& frame) {
    XacroFrame inner;
    inner.around = &frame;
    const TiXmlElement* block = element.FirstChildElement();
    for (const std::string& parameter : parametersOf(attributeOf(*macro.element, "params"))) {
      if (parameter[0] == '*') {
        if (block == nullptr) refuse(element, "lacks the block '" + parameter + "'");
        std::vector<const TiXmlElement*>& given =
            inner.blocks[parameter.substr(parameter.find_last_of('*') + 1)];
        if (parameter.rfind("**", 0) != 0)
          given.push_back(block);
        else
          for (const TiXmlElement* each = block->FirstChildElement(); each; each = each->NextSiblingElement())
            given.push_back(each);
        block = block->NextSiblingElement();
        continue;
      }
      setParameter(parameter, element, inner);
    }
    const std::string before = file_;
    file_ = macro.file;
    expandChildren(*macro.element, into, inner);
    file_ = before;
  }

  /// `name`, `name:=value`, `name:=^` and `name:=^|value`, the last two for a value from around the call.
  void setParameter(const std::string& parameter, const TiXmlElement& element, XacroFrame& inner) {
    const std::size_t colon = parameter.find(":=");
    const std::string name = parameter.substr(0, colon);
    if (const char* given = element.Attribute(name.c_str())) {
      inner.properties[name] = valueOf(given, *inner.around, element);
      return;
    }
    if (colon == std::string::npos) refuse(element, "lacks the parameter '" + name + "'");
    std::string value = parameter.substr(colon + 2);
    if (value.rfind('^', 0) == 0) {
      if (property(*inner.around, name)) return;
      value = value.size() > 2 ? value.substr(2) : "";
    }
    if (value.size() >= 2 && value.front() == '\'' && value.back() == '\'')
      value = value.substr(1, value.size() - 2);
    inner.properties[name] = valueOf(value, inner, element);
  }

  std::vector<std::string> packages_;
  std::map<std::string, std::string> arguments_;
  std::string file_;
  std::vector<std::unique_ptr<TiXmlDocument>> documents_;
  std::map<std::string, XacroMacro> macros_;
  int depth_ = 0;
};

}  // namespace

std::string expandXacro(const std::string& path, const std::map<std::string, std::string>& arguments,
                        const std::vector<std::string>& packages) {
  return Expansion(std::filesystem::absolute(path).lexically_normal().string(), arguments, packages).run();
}

}  // namespace lamina
