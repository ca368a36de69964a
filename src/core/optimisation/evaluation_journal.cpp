// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/evaluation_journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <set>

#include "journal_lines.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

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

}  // namespace

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
  const auto tell = [&](const Evaluation& evaluation) {
    if (done) done(evaluation);
  };
  std::vector<DesignPoint> untried;
  std::set<DesignPoint> seen;
  std::vector<std::size_t> repeated;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const Evaluation* known = journal_->find(points[i])) {
      tell(*known);
    } else if (seen.insert(points[i]).second) {
      untried.push_back(points[i]);
    } else {
      repeated.push_back(i);
    }
  }
  const auto noteDown = [&](const Evaluation& evaluation) {
    if (seen.count(evaluation.point) == 0 || journal_->find(evaluation.point) != nullptr) return;
    journal_->add(evaluation);
    tell(evaluation);
  };
  std::vector<Evaluation> found;
  if (!untried.empty()) found = inner_.evaluate(untried, noteDown, progress);
  if (found.size() != untried.size())
    throw Error(ErrorCode::Internal, std::to_string(found.size()) + " evaluations of " +
                                         std::to_string(untried.size()) + " points; expected as many");
  // What the evaluator did not report of, or reported of at another point, is noted at the point asked for.
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i].point = untried[i];
    noteDown(found[i]);
  }
  for (const std::size_t i : repeated) tell(*journal_->find(points[i]));
  std::vector<Evaluation> evaluations;
  evaluations.reserve(points.size());
  for (const DesignPoint& point : points) evaluations.push_back(*journal_->find(point));
  return evaluations;
}

std::vector<Evaluation> JournalledEvaluator::evaluations() const { return journal_->evaluations(); }

}  // namespace lamina
