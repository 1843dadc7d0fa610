#include "svg_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

namespace settle::compare::report {

namespace {

/// Reads a path from left to right.
class PathReader {
public:
  explicit PathReader(std::string_view text) : text_(text) {}

  std::optional<std::vector<SvgLine>> read() {
    while (skip_blanks()) {
      if (std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) command_ = text_[at_++];
      if (!step()) return {};
    }
    return std::move(lines_);
  }

private:
  bool skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == ',' || text_[at_] == '\n'))
      ++at_;
    return at_ < text_.size();
  }
  double number() {
    skip_blanks();
    const std::string rest(text_.substr(at_, 32));
    char* end = nullptr;
    const double value = std::strtod(rest.c_str(), &end);
    understood_ &= end != rest.c_str();
    at_ += static_cast<std::size_t>(end - rest.c_str());
    return value;
  }
  /// One command with its numbers. False: one that is not known, or not in its place.
  bool step() {
    if (command_ == 'M') {
      const double x = number();
      lines_.push_back({.points = {{x, number()}}});
      command_ = 'L'; // what follows without a letter
      return understood_;
    }
    if (lines_.empty()) return false;
    SvgLine& line = lines_.back();
    const SvgPoint last = line.points.back();
    if (command_ == 'L') {
      const double x = number();
      line.points.push_back({x, number()});
    } else if (command_ == 'h') {
      line.points.push_back({last.x + number(), last.y});
    } else if (command_ == 'v') {
      line.points.push_back({last.x, last.y + number()});
    } else if (command_ == 'z' || command_ == 'Z') {
      line.closed = true;
      command_ = ' ';
    } else {
      return false;
    }
    return understood_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  char command_ = ' ';
  bool understood_ = true;
  std::vector<SvgLine> lines_;
};

double distance_from_segment(const SvgPoint& point, const SvgPoint& from, const SvgPoint& to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double length2 = dx * dx + dy * dy;
  double along = length2 > 0.0 ? ((point.x - from.x) * dx + (point.y - from.y) * dy) / length2 : 0.0;
  along = std::clamp(along, 0.0, 1.0);
  return std::hypot(point.x - from.x - along * dx, point.y - from.y - along * dy);
}

/// Marks which points between two that stay have to stay too.
void mark(const std::vector<SvgPoint>& points, std::size_t first, std::size_t last, double tolerance,
          std::vector<bool>& stays) {
  double farthest = tolerance;
  std::size_t split = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double distance = distance_from_segment(points[i], points[first], points[last]);
    if (distance <= farthest) continue;
    farthest = distance;
    split = i;
  }
  if (split == first) return;
  stays[split] = true;
  mark(points, first, split, tolerance, stays);
  mark(points, split, last, tolerance, stays);
}

/// The unit of a written coordinate.
long tenths(double value) {
  return std::lround(10.0 * value);
}

std::string text_of_tenths(long value) {
  const long size = std::labs(value);
  std::string text = value < 0 ? "-" : "";
  if (size >= 10 || size == 0) text += std::to_string(size / 10);
  if (size % 10 != 0) text += fmt::format(".{}", size % 10);
  return text;
}

/// One more number, with no more before it than is needed.
void append(std::string& text, long value) {
  const std::string number = text_of_tenths(value);
  const bool parted = text.empty() || std::isalpha(static_cast<unsigned char>(text.back())) != 0;
  if (!parted && number.front() != '-') text += ' ';
  text += number;
}

/// A step from one point to the next; along an axis it is one number.
void append_step(std::string& text, char& command, long x, long y) {
  const char wanted = y == 0 ? 'h' : x == 0 ? 'v' : 'l';
  if (wanted != command) text += wanted;
  command = wanted;
  if (wanted != 'v') append(text, x);
  if (wanted != 'h') append(text, y);
}

/// To the first point of a line from where the one before it has ended, whichever way is shorter.
void append_start(std::string& text, long x, long y, const std::optional<std::pair<long, long>>& from) {
  std::string absolute = "M", relative = "m";
  append(absolute, x);
  append(absolute, y);
  if (from) {
    append(relative, x - from->first);
    append(relative, y - from->second);
  }
  text += from && relative.size() < absolute.size() ? relative : absolute;
}

/// `end`: where the line before it has ended, nothing before the first; where this one has.
void append(std::string& text, const SvgLine& line, std::optional<std::pair<long, long>>& end) {
  long x = tenths(line.points.front().x), y = tenths(line.points.front().y);
  const std::pair start{x, y};
  append_start(text, x, y, end);
  if (line.points.size() == 1) text += "h0";
  char command = 'M';
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const long next_x = tenths(line.points[i].x), next_y = tenths(line.points[i].y);
    append_step(text, command, next_x - x, next_y - y);
    x = next_x;
    y = next_y;
  }
  if (line.closed) text += 'z';
  end = line.closed ? start : std::pair{x, y};
}

} // namespace

std::optional<std::vector<SvgLine>> parse_path(std::string_view text) {
  return PathReader(text).read();
}

SvgLine simplified(const SvgLine& line, double tolerance) {
  if (line.points.size() < 3) return line;
  std::vector<bool> stays(line.points.size(), false);
  stays.front() = stays.back() = true;
  mark(line.points, 0, line.points.size() - 1, tolerance, stays);
  SvgLine left{.points = {}, .closed = line.closed};
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (stays[i]) left.points.push_back(line.points[i]);
  }
  return left;
}

std::string short_coordinate(double value) {
  return text_of_tenths(tenths(value));
}

std::string path_text(const std::vector<SvgLine>& lines) {
  std::string text;
  std::optional<std::pair<long, long>> end;
  for (const SvgLine& line : lines)
    append(text, line, end);
  return text;
}

} // namespace settle::compare::report
