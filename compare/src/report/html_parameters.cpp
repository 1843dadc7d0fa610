#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "html_parts.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/document.hpp"
#include "settle/exchange/program.hpp"

namespace settle::compare::report {

namespace {

namespace document = exchange::document;
using nlohmann::json;

/// What stands at a name of an object, an empty object if nothing does. A reference into `object`: the schema is large.
const json& child(const json& object, const char* name) {
  static const json nothing = json::object();
  const auto found = object.find(name);
  return found == object.end() ? nothing : *found;
}

/// The schema of a key: among the properties of its table, or what any key of a table of free names is.
const json& schema_of(const json& table, const std::string& key) {
  const json& properties = child(table, "properties");
  const auto found = properties.find(key);
  return found == properties.end() ? child(table, "additionalProperties") : *found;
}

/// What a key means; an array of tables is described with its entries. Empty where nothing is said.
std::string meaning_of(const json& facts) {
  for (const json* place : {&facts, &child(facts, "items")})
    if (const auto* text = child(*place, "description").get_ptr<const std::string*>()) return *text;
  return "";
}

/// Tables that no solver of this run reads, and keys the page shows elsewhere.
bool is_left_out(const RunOutcome& run, const std::string& key) {
  const auto runs = [&](const char* solver) {
    for (const SolverRun& each : run.solvers) {
      if (each.solver == solver) return true;
    }
    return false;
  };
  if (key == "mpm" || key == "fem") return !runs(key.c_str());
  if (key == "mpm.quasi_static") return run.study.mpm.scheme != exchange::Scheme::quasi_static;
  if (key == "mpm.explicit") return run.study.mpm.scheme != exchange::Scheme::explicit_dynamic;
  return key == "check" || key == "converge" || key == "title" || key == "source" || key == "format";
}

/// An array whose entries are read one by one: tables (supports, polygons), and texts (formulas).
const document::List* entries_of(const document::Value& value) {
  const auto* list = std::get_if<document::List>(&value.data);
  const auto is_large = [](const document::Value& entry) {
    return std::holds_alternative<document::Table>(entry.data) || std::holds_alternative<std::string>(entry.data);
  };
  return list != nullptr && !list->empty() && is_large(list->front()) ? list : nullptr;
}

/// A key of a case as it was run.
struct Parameter {
  std::string key, value, meaning;
};

/// "Pa" of "Young's modulus [Pa]"; of several the last, empty where there is none.
std::string unit_in(const std::string& meaning) {
  const std::size_t open = meaning.rfind('[');
  const std::size_t close = meaning.find(']', open);
  const bool is_unit = open != std::string::npos && close != std::string::npos && meaning[open - 1] == ' ';
  return is_unit ? meaning.substr(open + 1, close - open - 1) : "";
}

/// A mesh is not for reading, but one can see whether it is the same.
std::string shown(const document::Value& value) {
  constexpr std::size_t longest = 2000;
  const std::string text = document::to_inline_toml(value);
  if (text.size() <= longest) return text;
  return fmt::format("{} characters, SHA-256 {}", text.size(), exchange::sha256(text));
}

void append(const RunOutcome& run, const document::Table& table, const json& schema, const std::string& path,
            std::vector<Parameter>& list) {
  for (const document::Entry& entry : table) {
    const std::string key = path.empty() ? entry.key : path + "." + entry.key;
    if (is_left_out(run, key)) continue;
    const json& facts = schema_of(schema, entry.key);
    if (const auto* inner = std::get_if<document::Table>(&entry.value.data)) {
      append(run, *inner, facts, key, list);
      continue;
    }
    const std::string meaning = meaning_of(facts);
    const document::List* entries = entries_of(entry.value);
    if (entries == nullptr) {
      list.push_back({key, shown(entry.value), meaning});
      continue;
    }
    for (std::size_t i = 0; i < entries->size(); ++i)
      list.push_back({fmt::format("{}.{}", key, i), document::to_inline_toml((*entries)[i]), i == 0 ? meaning : ""});
  }
}

std::vector<Parameter> parameters_of(const RunOutcome& run) {
  static const json schema = json::parse(exchange::case_schema());
  std::vector<Parameter> list;
  append(run, document::parse(exchange::to_toml(run.study), run.study.file), schema, "", list);
  return list;
}

} // namespace

Table parameter_table(const RunOutcome& run) {
  Table table{"Parameters, defaults filled in", {{"Key", "", false}, {"Value", "", false}, {"Unit", "", false}}, {}};
  for (const Parameter& parameter : parameters_of(run))
    table.rows.push_back({{.text = parameter.key}, {.text = parameter.value}, {.text = unit_in(parameter.meaning)}});
  return table;
}

Table glossary_table(const CampaignOutcome& outcome) {
  std::map<std::string, std::string> meanings;
  for (const RunOutcome& run : outcome.runs) {
    for (const Parameter& parameter : parameters_of(run)) {
      if (!parameter.meaning.empty()) meanings.emplace(parameter.key, parameter.meaning);
    }
  }
  Table table{"Keys of the cases of this page", {{"Key", "", false}, {"Meaning [unit]", "", false}}, {}};
  for (const auto& [key, meaning] : meanings)
    table.rows.push_back({{.text = key}, {.text = meaning}});
  return table;
}

} // namespace settle::compare::report
