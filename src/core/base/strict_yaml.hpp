// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>
#include <vector>

#include "lamina/base/quotation.hpp"
#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// A piece of a YAML document that knows where it stands, and refuses what does not fit by source, line and
/// key.
class StrictYaml {
 public:
  using Entries = std::vector<std::pair<std::string, StrictYaml>>;

  /// @param key  by which a person finds the piece; empty for the document
  StrictYaml(const YAML::Node& node, std::string source_name, std::string key);

  /// @throws InvalidConfig always
  [[noreturn]] void refuse(const std::string& what) const;

  bool isMap() const { return node_.IsMap(); }
  bool isList() const { return node_.IsSequence(); }
  bool isScalar() const { return node_.IsScalar(); }

  /// The entries of a map, in order.
  /// @throws InvalidConfig if it is none, or a key stands twice
  Entries entries() const;
  /// The same, of a map that may have these keys only.
  /// @throws InvalidConfig naming those it may have
  Entries entries(const std::vector<std::string>& allowed) const;
  /// The pieces of a list.
  /// @throws InvalidConfig if it is none
  std::vector<StrictYaml> pieces() const;

  /// @throws InvalidConfig if it is no single value
  std::string text() const;
  std::vector<std::string> texts() const;
  /// @throws InvalidConfig if it is no finite number
  double number() const;
  std::vector<double> numbers() const;
  /// @throws InvalidConfig if it is no whole number within the bounds
  int whole(int low, int high) const;
  /// @throws InvalidConfig if it is neither true nor false
  bool flag() const;

  /// Single values by dotted keys.
  /// @throws InvalidConfig if keys are nested more than ten deep, as those of an alias to itself are
  std::vector<SettingText> settings() const;

 private:
  Quotation keyQuotation() const;
  Entries entriesQuotedBy(const Quotation& quotation) const;
  void addSettings(const std::string& prefix, int depth, std::vector<SettingText>& found) const;

  YAML::Node node_;
  std::string source_name_;
  std::string key_;
};

}  // namespace lamina
