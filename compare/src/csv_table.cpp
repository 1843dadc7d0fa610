#include "csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare {

using exchange::Convention;
using exchange::FileError;

namespace {

std::vector<std::string> split(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::vector<std::string> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// Where the columns stand in the file.
struct Header {
  std::vector<std::size_t> position; ///< of each name asked for
  std::size_t cells = 0;
  std::size_t left_out = 0; ///< `cells` where there is no such column
};

Header read_header(const std::string& line, const std::string& file, std::span<const std::string_view> names,
                   std::string_view left_out) {
  const std::vector<std::string> cells = split(line);
  const auto find = [&](std::string_view name) {
    return static_cast<std::size_t>(std::find(cells.begin(), cells.end(), name) - cells.begin());
  };
  Header header{.position = {}, .cells = cells.size(), .left_out = find(left_out)};
  std::vector<std::string> missing;
  for (const std::string_view name : names) {
    header.position.push_back(find(name));
    if (header.position.back() == cells.size()) missing.push_back(fmt::format("\"{}\"", name));
  }
  if (missing.empty()) return header;
  const std::string first = missing.front();
  missing.erase(missing.begin());
  throw FileError({.where = file + ":1",
                   .what = fmt::format("the column {} is missing", first) +
                           (missing.empty() ? "" : fmt::format(", and so are {}", fmt::join(missing, ", "))),
                   .given = line,
                   .allowed = fmt::format("{}", fmt::join(names, ",")),
                   .remedy = {}});
}

double to_number(const std::string& cell, const std::string& where) {
  double number = 0.0;
  const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (problem != std::errc() || end != cell.data() + cell.size() || !std::isfinite(number)) {
    throw FileError(
        {.where = where, .what = "not a number", .given = cell, .allowed = "a finite number", .remedy = {}});
  }
  return number;
}

} // namespace

std::vector<std::vector<double>> read_csv(const std::filesystem::path& file, std::span<const std::string_view> names,
                                          std::string_view left_out) {
  std::ifstream input(file);
  if (!input)
    throw FileError({.where = file.string(),
                     .what = "the table cannot be read",
                     .given = {},
                     .allowed = {},
                     .remedy = "check the path; in [reference] it is relative to the case file"});
  std::string line;
  std::getline(input, line);
  const Header header = read_header(line, file.string(), names, left_out);
  std::vector<std::vector<double>> rows;
  for (int number = 2; std::getline(input, line); ++number) {
    if (line.empty()) continue;
    const std::string where = fmt::format("{}:{}", file.string(), number);
    const std::vector<std::string> cells = split(line);
    if (cells.size() != header.cells) {
      throw FileError({.where = where,
                       .what = fmt::format("{} cells instead of {}", cells.size(), header.cells),
                       .given = line,
                       .allowed = {},
                       .remedy = {}});
    }
    if (header.left_out < header.cells && to_number(cells[header.left_out], where) != 0.0) continue;
    std::vector<double> row;
    for (const std::size_t position : header.position)
      row.push_back(to_number(cells[position], where));
    rows.push_back(std::move(row));
  }
  return rows;
}

bool has_column(const std::filesystem::path& file, std::string_view name) {
  std::ifstream input(file);
  std::string line;
  std::getline(input, line);
  const std::vector<std::string> cells = split(line);
  return std::find(cells.begin(), cells.end(), name) != cells.end();
}

std::vector<int> layers_of(const std::vector<TablePoint>& points, const exchange::Case& study,
                           const std::filesystem::path& file) {
  const Convention convention = study.construction.convention;
  const bool by_height = convention == Convention::refill || convention == Convention::drop;
  std::map<double, double> first_stage;
  for (const TablePoint& each : points) {
    const auto known = first_stage.try_emplace(each.point, each.stage).first;
    known->second = std::min(known->second, each.stage);
  }
  std::vector<int> layers;
  for (const TablePoint& each : points) {
    const double layer =
        by_height ? std::ceil(each.placed_height / study.layer_thickness()) : first_stage.at(each.point);
    if (!(layer >= 1.0) || layer > each.stage || each.stage > study.n_stages()) {
      throw FileError(
          {.where = file.string(),
           .what = "the table does not belong to this case",
           .given = fmt::format("point {} at stage {}, placed at {} m", each.point, each.stage, each.placed_height),
           .allowed = fmt::format("{} layers of {} m, a point in a layer already placed", study.construction.layers,
                                  study.layer_thickness()),
           .remedy = "compare the table with a case of the same geometry and layers"});
    }
    layers.push_back(static_cast<int>(layer));
  }
  return layers;
}

} // namespace settle::compare
