// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/evaluation_journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// The lines of a journal of evaluations: each one JSON object, without the end of the line.
class JournalLines {
 public:
  JournalLines(const DesignSpace& space, const std::vector<std::string>& response_names,
               const std::string& fingerprint);

  const std::string& header() const { return header_; }

  /// @throws InvalidInput naming in what it differs from this header
  void requireHeader(const std::string& line) const;

  /// Reads back to the same values, those that are not finite too.
  std::string lineOf(const Evaluation& evaluation) const;

  /// @throws InvalidInput naming what is wrong with it
  Evaluation evaluationOf(const std::string& line) const;

 private:
  const DesignSpace& space_;
  const std::vector<std::string>& response_names_;
  std::string header_;
};

/// A file to which lines are added, by one process at a time.
class LineFile {
 public:
  explicit LineFile(std::string path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail("write");
    try {
      takeForOneself();
    } catch (...) {
      ::close(descriptor_);
      throw;
    }
  }
  ~LineFile() { ::close(descriptor_); }
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// Cuts off what stands after so many bytes.
  void truncate(std::size_t bytes) {
    if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) fail("write");
  }

  /// What was added is in the file when this returns, even if the process ends at once.
  void add(std::string line) {
    if (is_faulty_) throw FileError("'" + path_ + "' could not be written; nothing more is added to it");
    const off_t begin = ::lseek(descriptor_, 0, SEEK_END);
    if (begin < 0) fail("write");
    line += '\n';
    for (std::size_t written = 0; written < line.size();) {
      const ssize_t count = ::write(descriptor_, line.data() + written, line.size() - written);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) takeBack(begin);
      written += static_cast<std::size_t>(count);
    }
  }

 private:
  void takeForOneself() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail("read");
    if (!S_ISREG(status.st_mode)) throw FileError("journal '" + path_ + "' is no file");
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    if (errno == EWOULDBLOCK) throw FileError("journal '" + path_ + "' is written by another run");
    fail("lock");
  }

  /// A torn line does not stay: another run would add to it.
  [[noreturn]] void takeBack(off_t begin) {
    const int reason = errno;
    is_faulty_ = true;
    const bool is_torn = ::ftruncate(descriptor_, begin) != 0;
    errno = reason;
    fail(is_torn ? "write more than a part of the last line of" : "write");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError("cannot " + what + " '" + path_ + "': " + std::strerror(errno));
  }

  std::string path_;
  int descriptor_ = -1;
  bool is_faulty_ = false;
};

namespace {

using Json = nlohmann::ordered_json;

constexpr double kJournalInfinity = std::numeric_limits<double>::infinity();

std::string dumped(const Json& json) {
  // Messages of failures may hold any bytes.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json parsed(const std::string& line) {
  try {
    return Json::parse(line);
  } catch (const Json::exception&) {
    throw InvalidInput("is no JSON");
  }
}

Json toJson(const Variable& variable) {
  const char* kinds[] = {"continuous", "integer", "levels", "categorical"};
  Json json = {{"name", variable.name}, {"kind", kinds[static_cast<int>(variable.kind)]}};
  switch (variable.kind) {
    case VariableKind::Continuous:
    case VariableKind::Integer:
      json["low"] = variable.low;
      json["high"] = variable.high;
      break;
    case VariableKind::Levels:
      json["levels"] = variable.levels;
      break;
    case VariableKind::Categorical:
      json["choices"] = variable.choices;
      break;
  }
  return json;
}

/// JSON has no numbers that are not finite.
Json toJson(double number) {
  if (std::isfinite(number)) return number;
  if (std::isnan(number)) return "nan";
  return number > 0.0 ? "inf" : "-inf";
}

double numberOf(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return kJournalInfinity;
  if (json == "-inf") return -kJournalInfinity;
  throw InvalidInput("has " + dumped(json) + " where a number was expected");
}

double valueOf(const Variable& variable, const Json& json) {
  if (variable.kind != VariableKind::Categorical) return numberOf(json);
  if (!json.is_string()) throw InvalidInput("has " + dumped(json) + " for " + variable.name);
  return lamina::valueOf(variable, json.get<std::string>());
}

const Json& memberOf(const Json& json, const char* name, std::size_t size) {
  if (!json.is_object() || !json.contains(name) || !json[name].is_array())
    throw InvalidInput("has no list '" + std::string(name) + "'");
  if (json[name].size() != size)
    throw InvalidInput("has " + std::to_string(json[name].size()) + " numbers in '" + name + "'; expected " +
                       std::to_string(size));
  return json[name];
}

}  // namespace

JournalLines::JournalLines(const DesignSpace& space, const std::vector<std::string>& response_names,
                           const std::string& fingerprint)
    : space_(space), response_names_(response_names) {
  Json json = {{"lamina_journal", 1}, {"fingerprint", fingerprint}, {"variables", Json::array()}};
  for (const Variable& variable : space) json["variables"].push_back(toJson(variable));
  json["responses"] = response_names;
  header_ = dumped(json);
}

void JournalLines::requireHeader(const std::string& line) const {
  if (line == header_) return;
  const Json theirs = parsed(line);
  if (!theirs.is_object() || !theirs.contains("lamina_journal"))
    throw InvalidInput("is no header of a journal");
  const Json ours = Json::parse(header_);
  for (const auto& [key, value] : ours.items())
    if (!theirs.contains(key) || theirs[key] != value)
      throw InvalidInput("belongs to another study: " + key + " " +
                         (theirs.contains(key) ? dumped(theirs[key]) : "missing") + "; expected " +
                         dumped(value));
}

std::string JournalLines::lineOf(const Evaluation& evaluation) const {
  Json json = {{"point", Json::array()}};
  for (std::size_t i = 0; i < space_.size(); ++i) {
    const bool is_choice = space_[i].kind == VariableKind::Categorical;
    json["point"].push_back(is_choice ? Json(textOf(space_[i], evaluation.point[i]))
                                      : toJson(evaluation.point[i]));
  }
  if (isEvaluated(evaluation)) {
    json["responses"] = Json::array();
    for (const double response : evaluation.responses) json["responses"].push_back(toJson(response));
  } else {
    json["error"] = evaluation.error;
  }
  return dumped(json);
}

Evaluation JournalLines::evaluationOf(const std::string& line) const {
  const Json json = parsed(line);
  Evaluation evaluation;
  const Json& point = memberOf(json, "point", space_.size());
  for (std::size_t i = 0; i < space_.size(); ++i) evaluation.point.push_back(valueOf(space_[i], point[i]));
  requireWithin(space_, evaluation.point);
  if (json.contains("error")) {
    if (!json["error"].is_string() || json["error"] == "" || json.contains("responses"))
      throw InvalidInput("has an error that is no text, or responses beside it");
    evaluation.error = json["error"].get<std::string>();
    return evaluation;
  }
  for (const Json& response : memberOf(json, "responses", response_names_.size()))
    evaluation.responses.push_back(numberOf(response));
  return evaluation;
}

/// What is known of points, in memory and in the file.
class JournalledEvaluator::Journal {
 public:
  Journal(const DesignSpace& space, const std::vector<std::string>& response_names,
          const JournalSettings& settings)
      : lines_(space, response_names, settings.fingerprint), settings_(settings) {
    if (settings.path.empty()) return;
    file_ = std::make_unique<LineFile>(settings.path);
    settings.earlier == EarlierJournal::BeginAnew ? beginAt(0) : read();
  }

  /// Null if the point is still to be tried.
  const Evaluation* find(const DesignPoint& point) const {
    const auto found = places_.find(point);
    if (found == places_.end() || awaited_.count(point) > 0) return nullptr;
    return &evaluations_[found->second];
  }

  void add(const Evaluation& evaluation) {
    if (file_) file_->add(lines_.lineOf(evaluation));
    remember(evaluation);
    awaited_.erase(evaluation.point);
  }

  const std::vector<Evaluation>& evaluations() const { return evaluations_; }

 private:
  void read() {
    const std::string text = readFile(settings_.path);
    std::size_t begin = 0;
    for (std::size_t number = 1; begin < text.size(); ++number) {
      const std::size_t end = text.find('\n', begin);
      if (end == std::string::npos) break;
      take(text.substr(begin, end - begin), number);
      begin = end + 1;
    }
    if (begin == 0) requireOwn(text);
    beginAt(begin);
  }

  /// Lines are added after so many bytes.
  void beginAt(std::size_t bytes) {
    file_->truncate(bytes);
    if (bytes == 0) file_->add(lines_.header());
  }

  void take(const std::string& line, std::size_t number) {
    try {
      if (number == 1) return lines_.requireHeader(line);
      const Evaluation evaluation = lines_.evaluationOf(line);
      remember(evaluation);
      const bool is_awaited = !isEvaluated(evaluation) && settings_.earlier == EarlierJournal::RetryFailed;
      is_awaited ? void(awaited_.insert(evaluation.point)) : void(awaited_.erase(evaluation.point));
    } catch (const InvalidInput& error) {
      throw InvalidInput("journal '" + settings_.path + "' line " + std::to_string(number) + " " +
                         error.what());
    }
  }

  /// A file without a whole line is overwritten only if a header was begun in it.
  void requireOwn(const std::string& text) const {
    if (lines_.header().compare(0, text.size(), text) != 0)
      throw InvalidInput("journal '" + settings_.path + "' line 1 is no header of a journal");
  }

  void remember(const Evaluation& evaluation) {
    const auto [place, is_new] = places_.emplace(evaluation.point, evaluations_.size());
    if (is_new) {
      evaluations_.push_back(evaluation);
    } else {
      evaluations_[place->second] = evaluation;
    }
  }

  JournalLines lines_;
  JournalSettings settings_;
  std::unique_ptr<LineFile> file_;
  std::vector<Evaluation> evaluations_;
  std::map<DesignPoint, std::size_t> places_;
  std::set<DesignPoint> awaited_;  ///< failed earlier and are to be tried again
};

JournalledEvaluator::JournalledEvaluator(Evaluator& inner, const DesignSpace& space,
                                         const JournalSettings& settings)
    : inner_(inner), space_(space) {
  validate(space_);
  journal_ = std::make_unique<Journal>(space_, inner_.responseNames(), settings);
}

JournalledEvaluator::~JournalledEvaluator() = default;

const std::vector<std::string>& JournalledEvaluator::responseNames() const { return inner_.responseNames(); }

std::vector<Evaluation> JournalledEvaluator::evaluate(const std::vector<DesignPoint>& points,
                                                      const EvaluationListener& done, Progress& progress) {
  for (const DesignPoint& point : points) requireWithin(space_, point);
  const auto report = [&](const Evaluation& evaluation) {
    if (done) done(evaluation);
  };
  std::vector<DesignPoint> untried;
  std::set<DesignPoint> seen;
  std::vector<std::size_t> repeated;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const Evaluation* known = journal_->find(points[i])) {
      report(*known);
    } else if (seen.insert(points[i]).second) {
      untried.push_back(points[i]);
    } else {
      repeated.push_back(i);
    }
  }
  const auto noteDown = [&](const Evaluation& evaluation) {
    if (seen.count(evaluation.point) == 0 || journal_->find(evaluation.point) != nullptr) return;
    journal_->add(evaluation);
    report(evaluation);
  };
  std::vector<Evaluation> found;
  if (!untried.empty()) found = inner_.evaluate(untried, noteDown, progress);
  if (found.size() != untried.size())
    throw Error(ErrorCode::Internal, std::to_string(found.size()) + " evaluations of " +
                                         std::to_string(untried.size()) + " points; expected as many");
  // A point that the evaluator did not report, or reported at another place, is noted as the point asked for.
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i].point = untried[i];
    noteDown(found[i]);
  }
  for (const std::size_t i : repeated) report(*journal_->find(points[i]));
  std::vector<Evaluation> evaluations;
  evaluations.reserve(points.size());
  for (const DesignPoint& point : points) evaluations.push_back(*journal_->find(point));
  return evaluations;
}

std::vector<Evaluation> JournalledEvaluator::evaluations() const { return journal_->evaluations(); }

}  // namespace lamina
