#include "formula_tree.hpp"

#include <array>
#include <cctype>
#include <string_view>

namespace settle::compare::report {

namespace {

using Kind = FormulaNode::Kind;

/// Operators of two operands, those that bind least first; the last level groups from the right.
const std::vector<std::vector<std::string_view>>& levels() {
  static const std::vector<std::vector<std::string_view>> all{
      {"="}, {"?"}, {"||"}, {"&&"}, {"<=", ">=", "!=", "==", "<", ">"}, {"+", "-"}, {"*", "/"}, {"^"}};
  return all;
}
constexpr std::size_t choice_level = 1, product_level = 6, power_level = 7;

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Recursive descent; throws `Unknown` at whatever it does not know.
class Reader {
public:
  struct Unknown {};

  explicit Reader(const std::string& text) : text_(text) {}

  FormulaNode whole() {
    FormulaNode node = at_level(0);
    if (next() != '\0') throw Unknown{};
    return node;
  }

private:
  char next() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
      ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(std::string_view token) {
    if (next() == '\0' || text_.compare(at_, token.size(), token) != 0) return false;
    // "=" is not the half of "=="
    if (token == "=" && at_ + 1 < text_.size() && text_[at_ + 1] == '=') return false;
    at_ += token.size();
    return true;
  }

  void need(std::string_view token) {
    if (!take(token)) throw Unknown{};
  }

  std::string operator_of(std::size_t level) {
    for (const std::string_view token : levels()[level])
      if (take(token)) return std::string(token);
    return {};
  }

  FormulaNode at_level(std::size_t level) {
    if (level == product_level + 1) return power();
    FormulaNode node = level == product_level ? signed_operand() : at_level(level + 1);
    for (std::string found = operator_of(level); !found.empty(); found = operator_of(level)) {
      if (level == choice_level) return choice(std::move(node));
      FormulaNode right = level == product_level ? signed_operand() : at_level(level + 1);
      node = {Kind::binary, found, {std::move(node), std::move(right)}};
    }
    return node;
  }

  FormulaNode choice(FormulaNode condition) {
    FormulaNode first = at_level(choice_level);
    need(":");
    FormulaNode second = at_level(choice_level);
    return {Kind::choice, "?", {std::move(condition), std::move(first), std::move(second)}};
  }

  /// A sign binds less than a power, more than a product.
  FormulaNode signed_operand() {
    for (const std::string_view sign : {"-", "+", "!"})
      if (take(sign)) return {Kind::sign, std::string(sign), {signed_operand()}};
    return power();
  }

  FormulaNode power() {
    FormulaNode base = operand();
    if (operator_of(power_level).empty()) return base;
    return {Kind::binary, "^", {std::move(base), signed_operand()}};
  }

  FormulaNode operand() {
    const char first = next();
    if (is_digit(first) || first == '.') return {Kind::number, number(), {}};
    if (is_letter(first)) return name();
    need("(");
    FormulaNode inner = at_level(choice_level);
    need(")");
    return inner;
  }

  std::string number() {
    const std::size_t start = at_;
    const auto digits = [&] {
      while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.'))
        ++at_;
    };
    digits();
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      if (at_ == text_.size() || !is_digit(text_[at_])) throw Unknown{};
      digits();
    }
    return text_.substr(start, at_ - start);
  }

  FormulaNode name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_])))
      ++at_;
    FormulaNode node{Kind::name, text_.substr(start, at_ - start), {}};
    if (at_ < text_.size() && text_[at_] == '_') node = {Kind::index, "", {std::move(node), index()}};
    if (next() != '(') return node;
    need("(");
    FormulaNode call{Kind::call, "", {std::move(node)}};
    do
      call.parts.push_back(at_level(choice_level));
    while (take(","));
    need(")");
    return call;
  }

  FormulaNode index() {
    ++at_;
    if (take("{")) {
      FormulaNode inner = at_level(choice_level);
      need("}");
      return inner;
    }
    const std::size_t start = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '_'))
      ++at_;
    if (at_ == start) throw Unknown{};
    const std::string text = text_.substr(start, at_ - start);
    return {is_digit(text.front()) ? Kind::number : Kind::name, text, {}};
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

} // namespace

int binding(const FormulaNode& node) {
  constexpr int sign = 2 * static_cast<int>(product_level) + 1; // between a product and a power
  if (node.kind == Kind::sign) return sign;
  if (node.kind == Kind::choice) return 2 * static_cast<int>(choice_level);
  for (std::size_t level = 0; node.kind == Kind::binary && level < levels().size(); ++level) {
    for (const std::string_view token : levels()[level])
      if (node.text == token) return 2 * static_cast<int>(level);
  }
  return 2 * static_cast<int>(levels().size());
}

std::optional<FormulaNode> formula_tree(const std::string& text) {
  try {
    return Reader(text).whole();
  } catch (const Reader::Unknown&) {
    return {};
  }
}

} // namespace settle::compare::report
