#include "gmsh_file.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"

namespace settle::exchange {
namespace {

/// Words of a text, line by line. Numbers do not depend on the language of the system.
class FileWords {
public:
  FileWords(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// The next word; in quotes, what is between them. Empty at the end of the text.
  std::string_view next() {
    skip_blanks();
    if (at_ == text_.size()) return {};
    if (text_[at_] == '"') return quoted();
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]))
      ++at_;
    return text_.substr(start, at_ - start);
  }

  template <class Number>
  Number number() {
    const std::string_view word = next();
    Number value{};
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size())
      refuse({.what = word.empty() ? "the mesh ends too early" : "the mesh holds a word where a number belongs",
              .given = std::string(word),
              .allowed = "a complete ASCII file of version 2.2 or 4.1",
              .remedy = "write it again: gmsh -format msh41, Mesh.Binary = 0"});
    return value;
  }
  int integer() { return number<int>(); }
  /// How many of something follow: no more than there is text left.
  int count() {
    const int count = integer();
    if (count < 0 || static_cast<std::size_t>(count) > text_.size() - at_)
      refuse({.what = "the mesh ends too early",
              .given = fmt::format("{} entries are to follow", count),
              .allowed = "a complete file",
              .remedy = "write it again"});
    return count;
  }
  double real() { return number<double>(); }
  void skip(int words) {
    for (int i = 0; i < words; ++i)
      next();
  }

  [[nodiscard]] int line() const { return line_; }

  [[noreturn]] void refuse(Complaint complaint) const {
    complaint.where = fmt::format("{}:{}", name_, line_);
    throw InputError(complaint);
  }

private:
  static bool is_blank(char letter) { return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n'; }

  void skip_blanks() {
    for (; at_ < text_.size() && is_blank(text_[at_]); ++at_)
      if (text_[at_] == '\n') ++line_;
  }

  std::string_view quoted() {
    const std::size_t start = at_ + 1, end = std::min(text_.find('"', start), text_.size());
    at_ = std::min(end + 1, text_.size());
    return text_.substr(start, end - start);
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// What there is to know of a kind of elements with straight edges.
struct ElementKind {
  int dimension, nodes;
};

std::optional<ElementKind> kind_of(int type) {
  switch (type) {
  case 1: // line
    return ElementKind{1, 2};
  case 2: // triangle
    return ElementKind{2, 3};
  case 3: // quadrilateral
    return ElementKind{2, 4};
  case 4: // tetrahedron
    return ElementKind{3, 4};
  case 5: // hexahedron
    return ElementKind{3, 8};
  case 6: // prism
    return ElementKind{3, 6};
  case 7: // pyramid
    return ElementKind{3, 5};
  case 15: // point
    return ElementKind{0, 1};
  default:
    return {};
  }
}

class GmshParser {
public:
  GmshParser(const std::string& text, const std::string& name) : words_(text, name) {}

  GmshFile parse() {
    read_format();
    for (std::string_view header = words_.next(); !header.empty(); header = words_.next())
      read_section(header);
    return std::move(file_);
  }

private:
  using Entity = std::pair<int, int>; ///< dimension, tag

  void read_format() {
    const std::string_view header = words_.next();
    if (header != "$MeshFormat")
      words_.refuse({.what = "the file is no mesh of Gmsh",
                     .given = std::string(header.substr(0, 40)),
                     .allowed = "a file that begins with $MeshFormat",
                     .remedy = "write it with gmsh -format msh41"});
    const std::string version(words_.next());
    is_4_ = version == "4.1";
    if (!is_4_ && version != "2.2")
      words_.refuse({.what = "the mesh is of a version of the format that is not read",
                     .given = version,
                     .allowed = "2.2 or 4.1",
                     .remedy = "write it with gmsh -format msh41"});
    if (words_.integer() != 0)
      words_.refuse({.what = "the mesh is a binary file",
                     .given = {},
                     .allowed = "ASCII",
                     .remedy = "set Mesh.Binary = 0 in Gmsh and write it again"});
    words_.next(); // size of real numbers in binary files
    expect_end("$MeshFormat");
  }

  void read_section(std::string_view header) {
    if (header == "$PhysicalNames")
      read_names();
    else if (header == "$Entities" && is_4_)
      read_entities();
    else if (header == "$Nodes")
      is_4_ ? read_blocks_of_nodes() : read_nodes();
    else if (header == "$Elements")
      is_4_ ? read_blocks_of_elements() : read_elements();
    else
      return skip_section(header);
    expect_end(header);
  }

  static std::string end_of(std::string_view header) { return fmt::format("$End{}", header.substr(1)); }

  void skip_section(std::string_view header) {
    const std::string end = end_of(header);
    for (std::string_view word = words_.next(); word != end; word = words_.next())
      if (word.empty()) refuse_end(end, word);
  }

  void expect_end(std::string_view header) {
    const std::string end = end_of(header);
    if (const std::string_view word = words_.next(); word != end) refuse_end(end, word);
  }

  [[noreturn]] void refuse_end(const std::string& end, std::string_view word) const {
    words_.refuse({.what = "a section of the mesh does not end where it should",
                   .given = word.empty() ? "the end of the file" : std::string(word),
                   .allowed = end,
                   .remedy = "write the file again"});
  }

  void read_names() {
    const int count = words_.count();
    for (int i = 0; i < count; ++i) {
      const int dimension = words_.integer(), number = words_.integer();
      file_.names[{dimension, number}] = std::string(words_.next());
    }
  }

  /// Only their physical groups are of use.
  void read_entities() {
    std::array<int, 4> counts{};
    for (int& count : counts)
      count = words_.count();
    for (int dimension = 0; dimension < 4; ++dimension)
      for (int i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
        std::vector<int>& groups = groups_of_[{dimension, words_.integer()}];
        words_.skip(dimension == 0 ? 3 : 6); // where it is
        for (int left = words_.count(); left > 0; --left)
          groups.push_back(std::abs(words_.integer()));
        if (dimension > 0) words_.skip(words_.count()); // what bounds it
      }
  }

  void add_node(std::int64_t tag) {
    std::array<double, 3> position{};
    for (double& coordinate : position)
      coordinate = words_.real();
    places_[tag] = static_cast<unsigned>(file_.nodes.size());
    file_.nodes.push_back(position);
  }

  void read_nodes() {
    for (int left = words_.count(); left > 0; --left)
      add_node(words_.number<std::int64_t>());
  }

  void read_blocks_of_nodes() {
    const int blocks = words_.count();
    words_.skip(3);
    for (int block = 0; block < blocks; ++block) {
      const int dimension = words_.integer();
      words_.integer(); // entity
      const bool parametric = words_.integer() != 0;
      std::vector<std::int64_t> tags(static_cast<std::size_t>(words_.count()));
      for (std::int64_t& tag : tags)
        tag = words_.number<std::int64_t>();
      for (const std::int64_t tag : tags) {
        add_node(tag);
        if (parametric) words_.skip(dimension);
      }
    }
  }

  ElementKind require_kind(int type) const {
    if (const auto kind = kind_of(type)) return *kind;
    words_.refuse({.what = "the mesh has elements that are not read",
                   .given = fmt::format("elements of Gmsh's type {}", type),
                   .allowed = "lines, quadrilaterals and hexahedra with straight edges",
                   .remedy = "set Mesh.ElementOrder = 1 in Gmsh and mesh again"});
  }

  void add_element(const ElementKind& kind, int tag, const std::vector<int>& groups) {
    GmshElement element{.tag = tag, .line = words_.line(), .dimension = kind.dimension, .groups = groups};
    for (int i = 0; i < kind.nodes; ++i) {
      const auto number = words_.number<std::int64_t>();
      const auto place = places_.find(number);
      if (place == places_.end())
        words_.refuse({.what = fmt::format("element {} has a node that is not in the file", tag),
                       .given = fmt::format("node {}", number),
                       .allowed = "nodes of the section $Nodes, which comes first",
                       .remedy = "write the file again"});
      element.nodes.push_back(place->second);
    }
    if (kind.dimension > 0) file_.elements.push_back(std::move(element));
  }

  void read_elements() {
    for (int left = words_.count(); left > 0; --left) {
      const int tag = words_.integer();
      const ElementKind kind = require_kind(words_.integer());
      const int tags = words_.count();
      std::vector<int> groups;
      if (tags > 0) groups.push_back(std::abs(words_.integer()));
      words_.skip(tags - 1);
      add_element(kind, tag, groups);
    }
  }

  void read_blocks_of_elements() {
    const int blocks = words_.count();
    words_.skip(3);
    for (int block = 0; block < blocks; ++block) {
      const int dimension = words_.integer(), entity = words_.integer();
      const ElementKind kind = require_kind(words_.integer());
      for (int left = words_.count(); left > 0; --left)
        add_element(kind, words_.integer(), groups_of_[{dimension, entity}]);
    }
  }

  FileWords words_;
  bool is_4_ = true;
  GmshFile file_;
  std::map<Entity, std::vector<int>> groups_of_;      ///< physical groups of each entity
  std::unordered_map<std::int64_t, unsigned> places_; ///< of nodes, by their numbers in the file
};

} // namespace

GmshFile parse_gmsh(const std::string& text, const std::string& name) {
  return GmshParser(text, name).parse();
}

} // namespace settle::exchange
