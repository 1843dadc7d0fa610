#include "shared_shapes.hpp"

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace settle::compare::report {

namespace {

constexpr std::size_t shortest = 50; // characters: what refers to a shape has 20
constexpr std::size_t fewest = 3;    // uses, so that it pays

/// A shape as it stands in the page.
struct Extent {
  std::size_t begin = 0, end = 0;
};

/// The end of an element that begins at `at`; nothing for one that is not known.
std::optional<std::size_t> end_of_element(std::string_view page, std::size_t at) {
  const auto after = [&](std::string_view text) { return page.find(text, at) + text.size(); };
  const std::string_view rest = page.substr(at);
  if (rest.starts_with("<path ")) return after("/>");
  if (rest.starts_with("<text ")) return after("</text>");
  if (rest.starts_with("<g ")) return after("</g>");
  return {};
}

/// The elements of a drawing whose content begins at `at`; none where one of them is not known.
std::vector<Extent> shapes_of_drawing(std::string_view page, std::size_t at, std::size_t end) {
  std::vector<Extent> shapes;
  while (at < end) {
    const auto next = end_of_element(page, at);
    if (!next || *next > end) return {};
    shapes.push_back({at, *next});
    at = *next;
  }
  return shapes;
}

std::vector<Extent> shapes_in(std::string_view page) {
  std::vector<Extent> shapes;
  for (std::size_t at = page.find("<svg "); at != std::string_view::npos; at = page.find("<svg ", at + 1)) {
    const std::size_t content = page.find('>', at) + 1, end = page.find("</svg>", at);
    for (const Extent& shape : shapes_of_drawing(page, content, end))
      if (shape.end - shape.begin >= shortest) shapes.push_back(shape);
  }
  return shapes;
}

/// Shape -> its name in the page, of those that are worth sharing; named in the order in which they first appear.
std::map<std::string_view, std::string> shared_among(std::string_view page, const std::vector<Extent>& shapes) {
  std::map<std::string_view, std::size_t> uses;
  const auto text_of = [&](const Extent& shape) { return page.substr(shape.begin, shape.end - shape.begin); };
  for (const Extent& shape : shapes)
    ++uses[text_of(shape)];
  std::map<std::string_view, std::string> names;
  for (const Extent& shape : shapes)
    if (uses.at(text_of(shape)) >= fewest) names.try_emplace(text_of(shape), fmt::format("s{}", names.size()));
  return names;
}

/// All of them, drawn nowhere.
std::string definitions(const std::map<std::string_view, std::string>& names) {
  std::string text = R"(<svg class="shared" width="0" height="0" aria-hidden="true"><defs>)";
  std::vector<std::string_view> shapes(names.size());
  for (const auto& [shape, name] : names)
    shapes[std::stoul(name.substr(1))] = shape;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::size_t behind_name = shapes[i].find(' '); // "<path": there the id goes
    text += fmt::format("{} id=\"s{}\"{}", shapes[i].substr(0, behind_name), i, shapes[i].substr(behind_name));
  }
  return text + "</defs></svg>";
}

} // namespace

std::string with_shared_shapes(const std::string& page) {
  const std::vector<Extent> shapes = shapes_in(page);
  const auto names = shared_among(page, shapes);
  const std::size_t body = page.find('>', page.find("<body")) + 1;
  if (names.empty() || body == 0) return page;
  std::string text = page.substr(0, body) + definitions(names);
  std::size_t done = body;
  for (const Extent& shape : shapes) {
    const auto name = names.find(std::string_view(page).substr(shape.begin, shape.end - shape.begin));
    if (name == names.end()) continue;
    text.append(page, done, shape.begin - done).append(fmt::format("<use href=\"#{}\"/>", name->second));
    done = shape.end;
  }
  return text.append(page, done);
}

} // namespace settle::compare::report
