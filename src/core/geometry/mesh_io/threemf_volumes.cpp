// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "threemf_volumes.hpp"

#include <zip.h>

#include <charconv>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/svg/xml_scanner.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostBytes = 64U << 20U;     // of a list of volumes
constexpr std::size_t kMostOfModel = 4ULL << 30U;  // bytes
constexpr const char* kModelRelation = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// By the numbers that the model gives its objects.
using NumberedVolumes = std::map<std::uint32_t, std::vector<VolumeRange>>;

struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Archive = std::unique_ptr<zip_t, DiscardArchive>;

Archive opened(std::string_view bytes, const std::string& name) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  Archive archive(source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error));
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive) return archive;
  if (source != nullptr) zip_source_free(source);
  throw InvalidMesh(name + ": no readable archive: " + reason);
}

/// The text of an entry; none if there is none of that name. Headers may state any size: only what is there
/// takes room.
std::optional<std::string> entryOf(const Archive& archive, const std::string& entry, std::size_t most_bytes,
                                   const std::string& name) {
  constexpr std::size_t kBlock = 1U << 20U;  // bytes
  if (zip_name_locate(archive.get(), entry.c_str(), 0) < 0) return std::nullopt;
  const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen(archive.get(), entry.c_str(), 0));
  std::string text;
  std::vector<char> block(kBlock);
  zip_int64_t count = file ? 0 : -1;
  while (file && (count = zip_fread(file.get(), block.data(), block.size())) > 0) {
    text.append(block.data(), static_cast<std::size_t>(count));
    if (text.size() > most_bytes)
      throw InvalidMesh(name + ": " + entry + " has more than " + std::to_string(most_bytes) +
                        " bytes; no more are read");
  }
  if (count < 0) throw InvalidMesh(name + ": " + entry + " cannot be read");
  return text;
}

/// Of any slicer's words; none for a volume of the part.
std::optional<VolumeKind> kindOfVolume(const std::string& word) {
  if (word == "ParameterModifier" || word == "modifier_part") return VolumeKind::Modifier;
  if (word == "NegativeVolume" || word == "negative_part") return VolumeKind::Negative;
  if (word == "SupportBlocker" || word == "support_blocker") return VolumeKind::SupportBlocker;
  if (word == "SupportEnforcer" || word == "support_enforcer") return VolumeKind::SupportEnforcer;
  return std::nullopt;
}

std::uint32_t numberOf(const XmlScanner& scanner, const XmlTag& tag, const std::string& key) {
  const std::string text = tag.attribute(key);
  std::uint32_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size())
    scanner.refuse(tag.line, key + " of " + tag.name + " is '" + text + "'; expected a number");
  return value;
}

class VolumeScanner {
 public:
  VolumeScanner(const std::string& text, const std::string& name) : scanner_(text, name) {}

  NumberedVolumes scan() {
    XmlTag tag;
    while (scanner_.next(tag)) {
      if (tag.is_end)
        end(tag);
      else
        begin(tag);
    }
    return std::move(found_);
  }

 private:
  void begin(const XmlTag& tag) {
    if (tag.name == "object") object_ = numberOf(scanner_, tag, "id");
    if (tag.name == "volume") {
      kind_.reset();
      range_ = {VolumeKind::Modifier, numberOf(scanner_, tag, "firstid"), numberOf(scanner_, tag, "lastid")};
    }
    if (tag.name == "part") beginPart(tag);
    if (tag.name == "metadata") addWord(tag);
  }

  void beginPart(const XmlTag& tag) {
    kind_ = kindOfVolume(tag.attribute("subtype"));
    if (!kind_) return;
    range_ = {*kind_, 0, std::numeric_limits<std::size_t>::max()};
    part_ = numberOf(scanner_, tag, "id");
    if (tag.is_empty) found_[part_] = {range_};
  }

  /// Of the volume or part that has begun; that of others is told apart by its end.
  void addWord(const XmlTag& tag) {
    const std::string key = tag.attribute("key");
    const std::string value = tag.attribute("value");
    if (key == "volume_type") kind_ = kindOfVolume(value);
    range_.settings.push_back({key, value});
  }

  void end(const XmlTag& tag) {
    if (tag.name == "volume" && kind_) {
      range_.kind = *kind_;
      found_[object_].push_back(range_);
    }
    if (tag.name == "part" && kind_) found_[part_] = {range_};
    if (tag.name == "volume" || tag.name == "part") kind_.reset();
  }

  XmlScanner scanner_;
  std::uint32_t object_ = 0;
  std::uint32_t part_ = 0;
  std::optional<VolumeKind> kind_;  ///< none for a volume of the part
  VolumeRange range_;
  NumberedVolumes found_;
};

/// Where the archive says that its model is.
std::string modelEntry(const Archive& archive, const std::string& name) {
  const std::string relations = entryOf(archive, "_rels/.rels", kMostBytes, name).value_or("");
  XmlScanner scanner(relations, name + ", _rels/.rels");
  XmlTag tag;
  while (scanner.next(tag)) {
    if (tag.is_end || tag.name != "Relationship" || tag.attribute("Type") != kModelRelation) continue;
    const std::string target = tag.attribute("Target");
    return target.substr(target.compare(0, 1, "/") == 0 ? 1 : 0);
  }
  throw InvalidMesh(name + ": _rels/.rels names no model; expected a relationship of type " +
                    std::string(kModelRelation));
}

/// The numbers of the objects of a model, in their order.
std::vector<std::uint32_t> objectNumbers(const std::string& model, const std::string& name) {
  std::vector<std::uint32_t> numbers;
  XmlScanner scanner(model, name);
  XmlTag tag;
  while (scanner.next(tag))
    if (!tag.is_end && tag.name == "object") numbers.push_back(numberOf(scanner, tag, "id"));
  return numbers;
}

/// By the order in which a model has its objects.
ObjectVolumes inOrder(NumberedVolumes numbered, const Archive& archive, const std::string& name) {
  const std::string entry = modelEntry(archive, name);
  const std::string model = entryOf(archive, entry, kMostOfModel, name).value_or("");
  ObjectVolumes ordered;
  std::size_t order = 0;
  for (const std::uint32_t number : objectNumbers(model, name + ", " + entry)) {
    if (auto found = numbered.extract(number)) ordered[order] = std::move(found.mapped());
    ++order;
  }
  if (numbered.empty()) return ordered;
  throw InvalidMesh(name + ": object " + std::to_string(numbered.begin()->first) +
                    " is listed with volumes that are no material, and is none of the " +
                    std::to_string(order) + " objects of " + entry + "; expected the number of one");
}

}  // namespace

ObjectVolumes objectVolumes(std::string_view archive_bytes, const std::string& name) {
  const Archive archive = opened(archive_bytes, name);
  for (const char* const entry : {"Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"}) {
    const auto text = entryOf(archive, entry, kMostBytes, name);
    if (!text) continue;
    NumberedVolumes numbered = VolumeScanner(*text, name + ", " + entry).scan();
    if (numbered.empty()) return {};
    return inOrder(std::move(numbered), archive, name);
  }
  return {};
}

}  // namespace lamina
