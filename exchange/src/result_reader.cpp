#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hdf5.hpp"
#include "result_layout.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::exchange {
namespace {

/// What every complaint about a result's content looks like.
struct Mismatch {
  std::string what, given, allowed, remedy;
};

template <class ErrorType = FileError>
[[noreturn]] void refuse(const hdf5::Group& group, const Mismatch& mismatch) {
  throw ErrorType({.where = group.file(),
                   .what = mismatch.what,
                   .given = mismatch.given,
                   .allowed = mismatch.allowed,
                   .remedy = mismatch.remedy});
}

/// Format, version and status, before anything else is looked at.
void check_head(const hdf5::Group& root) {
  const std::string format = root.has_attribute("format") ? root.text_attribute("format") : "no attribute `format`";
  if (format != layout::format)
    refuse(root,
           {"this HDF5 file is not a result", format, fmt::format("format = {}", layout::format), "check the path"});
  const std::int64_t version = root.integer_attribute("version");
  if (version != result_version)
    refuse<VersionError>(root,
                         {"the result has a version that this program does not read",
                          fmt::format("version {}", version), fmt::format("version {}", result_version),
                          version > result_version ? "use a newer build of this program" : "run the solver again"});
  const std::string status = root.has_attribute("status") ? root.text_attribute("status") : "no attribute `status`";
  if (status != layout::complete)
    refuse(root, {"the result is not complete", status, fmt::format("status = {}", layout::complete),
                  "the solver did not finish: run it again"});
}

template <class Enum>
Enum choice_attribute(const hdf5::Group& group, const std::string& name) {
  const std::string word = group.text_attribute(name);
  const auto& names = EnumNames<Enum>::names;
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end())
    refuse(group, {group.name_of(name) + " has an unknown value", word, fmt::format("{}", fmt::join(names, ", ")), {}});
  return static_cast<Enum>(found - names.begin());
}

Used read_used(const hdf5::Group& group) {
  Used used{.youngs_modulus = group.real_attribute("youngs_modulus"),
            .poissons_ratio = group.real_attribute("poissons_ratio"),
            .density = group.real_attribute("density"),
            .gravity = group.real_attribute("gravity"),
            .law = choice_attribute<Law>(group, "law"),
            .kinematics = choice_attribute<Kinematics>(group, "kinematics"),
            .convention = choice_attribute<Convention>(group, "convention"),
            .dimension = 0};
  const std::int64_t dimension = group.integer_attribute("dimension");
  if (dimension != 2 && dimension != 3)
    refuse(group, {group.name_of("dimension") + " has an unknown value", fmt::format("{}", dimension), "2 or 3", {}});
  used.dimension = static_cast<int>(dimension);
  return used;
}

Provenance read_provenance(const hdf5::Group& root, const std::string& case_text) {
  Provenance provenance{.solver = root.text_attribute("solver"),
                        .program_version = root.text_attribute("program_version"),
                        .commit = root.text_attribute("commit"),
                        .case_sha256 = root.text_attribute("case_sha256"),
                        .created = root.text_attribute("created"),
                        .threads = static_cast<int>(root.integer_attribute("threads")),
                        .wall_time = root.real_attribute("wall_time")};
  if (provenance.case_sha256 != sha256(case_text))
    refuse(root, {"case_sha256 does not belong to the text under /case", provenance.case_sha256, sha256(case_text),
                  "the file was changed after it was written, or its writer computes the sum of something else"});
  return provenance;
}

/// Every dataset of a group; the first one says how many points there are.
template <class Points>
Points read_points(const hdf5::Group& group, std::size_t dimension) {
  Points points;
  std::optional<std::size_t> rows;
  layout::for_each_array(points, dimension, [&](const char* name, std::size_t columns, auto& values) {
    using Number = typename std::decay_t<decltype(values)>::value_type;
    if (layout::is_optional(name) && !group.has(name)) return;
    hdf5::Array<Number> array = group.read_array<Number>(name);
    if (!rows) rows = array.sizes.empty() ? 0 : array.sizes.front();
    if (array.sizes != layout::sizes(*rows, columns))
      refuse(group, {group.name_of(name) + " has the wrong shape",
                     fmt::format("({})", fmt::join(array.sizes, ", ")),
                     fmt::format("({})", fmt::join(layout::sizes(*rows, columns), ", ")),
                     {}});
    values = std::move(array.values);
  });
  return points;
}

/// What reads one number from an attribute.
auto from(const hdf5::Group& group) {
  return [&group](const std::string& name, auto& value) {
    using Number = std::decay_t<decltype(value)>;
    if (name == "linear_solves" && !group.has_attribute(name)) return; // other codes may not count them
    if constexpr (std::is_floating_point_v<Number>) {
      value = group.real_attribute(name);
    } else {
      value = static_cast<Number>(group.integer_attribute(name));
    }
  };
}

std::vector<double> read_support_reactions(const hdf5::Group& group, std::size_t dimension) {
  hdf5::Array<double> array = group.read_array<double>(layout::support_reactions);
  if (array.sizes.size() != 2 || array.sizes[1] != dimension)
    refuse(group, {group.name_of(layout::support_reactions) + " has the wrong shape",
                   fmt::format("({})", fmt::join(array.sizes, ", ")),
                   fmt::format("(number of supports, {})", dimension),
                   {}});
  return std::move(array.values);
}

Stage read_stage(const hdf5::Group& group, std::size_t dimension) {
  Stage stage;
  layout::for_each_attribute(stage, from(group));
  stage.points = read_points<SamplePoints>(group.open_group("points"), dimension);
  if (group.has(layout::support_reactions)) stage.support_reactions = read_support_reactions(group, dimension);
  if (!group.has("probes")) return stage;
  const hdf5::Group probes = group.open_group("probes");
  for (const std::string& name : probes.names())
    stage.probes[name] = read_points<ProbeSamples>(probes.open_group(name), dimension);
  return stage;
}

/// A number of a run-out that cannot be, whatever the body.
void check_run_out(const hdf5::Group& group, const RunOut& run_out) {
  layout::for_each_attribute_of_run_out(run_out, [&](const std::string& name, const auto& value) {
    const bool is_energy = name.ends_with("_work") || name == "damping_loss" || name == "kinetic_energy";
    const auto number = static_cast<double>(value);
    if (!std::isfinite(number) || (!is_energy && number < 0.0))
      refuse(group, {group.name_of(name) + " is no such number",
                     fmt::format("{}", number),
                     is_energy ? "a number" : "a number from 0 on",
                     {}});
  });
}

RunOut read_run_out(const hdf5::Group& group, std::size_t dimension) {
  RunOut run_out;
  layout::for_each_attribute_of_run_out(run_out, from(group));
  check_run_out(group, run_out);
  run_out.state = read_stage(group.open_group(layout::run_out_state), dimension);
  return run_out;
}

std::optional<Failure> read_failure(const hdf5::Group& root, std::size_t dimension) {
  if (!root.has(layout::failure)) return {};
  const hdf5::Group group = root.open_group(layout::failure);
  Failure failure{.stage = static_cast<int>(group.integer_attribute("stage")), .share = group.real_attribute("share")};
  if (group.has(layout::run_out)) failure.run_out = read_run_out(group.open_group(layout::run_out), dimension);
  return failure;
}

std::vector<Stage> read_stages(const hdf5::Group& group, std::size_t dimension) {
  std::vector<Stage> stages;
  const std::size_t count = group.names().size();
  for (std::size_t number = 1; number <= count; ++number)
    stages.push_back(read_stage(group.open_group(layout::stage_name(number)), dimension));
  return stages;
}

} // namespace

Result read_result(const std::filesystem::path& path) {
  const hdf5::File file = hdf5::File::open(path);
  const hdf5::Group& root = file.root();
  check_head(root);
  Result result;
  result.case_text = root.read_text("case");
  result.provenance = read_provenance(root, result.case_text);
  result.used = read_used(root.open_group("used"));
  const auto dimension = static_cast<std::size_t>(result.used.dimension);
  result.stages = read_stages(root.open_group("stages"), dimension);
  result.failure = read_failure(root, dimension);
  return result;
}

} // namespace settle::exchange
