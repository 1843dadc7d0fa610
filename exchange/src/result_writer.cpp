#include <stdexcept>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>

#include "hdf5.hpp"
#include "result_layout.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::exchange {
namespace {

std::filesystem::path partial_name(const std::filesystem::path& file) {
  return file.string() + ".partial";
}

/// What can be known to fail before the solver has worked for it.
void check_target(const std::filesystem::path& file) {
  if (file.filename().empty() || std::filesystem::is_directory(file))
    throw FileError({.where = file.string(),
                     .what = "the result cannot be written",
                     .given = "a folder",
                     .allowed = "the path of a file",
                     .remedy = "name the result file, for instance result.h5"});
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw FileError({.where = file.string(),
                     .what = "the result cannot be written: there is no such folder",
                     .given = folder.string(),
                     .allowed = "a folder that exists and can be written",
                     .remedy = "create it, or choose another output"});
}

void write_used(const hdf5::Group& group, const Used& used) {
  group.write_attribute("youngs_modulus", used.youngs_modulus);
  group.write_attribute("poissons_ratio", used.poissons_ratio);
  group.write_attribute("density", used.density);
  group.write_attribute("gravity", used.gravity);
  group.write_attribute("law", std::string(name_of(used.law)));
  group.write_attribute("kinematics", std::string(name_of(used.kinematics)));
  group.write_attribute("convention", std::string(name_of(used.convention)));
  group.write_attribute("dimension", std::int64_t{used.dimension});
}

void write_head(const hdf5::Group& root, const std::string& solver, const std::string& case_text) {
  root.write_attribute("format", std::string(layout::format));
  root.write_attribute("version", std::int64_t{result_version});
  root.write_attribute("solver", solver);
  root.write_attribute("program_version", program_version());
  root.write_attribute("commit", program_commit());
  root.write_attribute("case_sha256", sha256(case_text));
  root.write_attribute("created", utc_now());
  root.write_text("case", case_text);
}

template <class Points>
void write_points(const hdf5::Group& group, const Points& points, std::size_t dimension) {
  layout::for_each_array(points, dimension, [&](const char* name, std::size_t columns, const auto& values) {
    if (values.empty() && layout::is_optional(name)) return;
    const std::size_t expected = points.size() * (columns == 0 ? 1 : columns);
    if (values.size() != expected)
      throw std::logic_error(
          fmt::format("{} has {} values instead of {}", group.name_of(name), values.size(), expected));
    group.write_array(name, layout::sizes(points.size(), columns), values);
  });
}

/// What writes one number as an attribute.
auto into(const hdf5::Group& group) {
  return [&group](const char* name, const auto& value) {
    using Number = std::conditional_t<std::is_floating_point_v<std::decay_t<decltype(value)>>, double, std::int64_t>;
    group.write_attribute(name, static_cast<Number>(value));
  };
}

void write_stage(const hdf5::Group& group, const Stage& stage, std::size_t dimension) {
  layout::for_each_attribute(stage, into(group));
  write_points(group.create_group("points"), stage.points, dimension);
  const hdf5::Group probes = group.create_group("probes");
  for (const auto& [name, samples] : stage.probes)
    write_points(probes.create_group(name), samples, dimension);
  if (!stage.support_reactions.empty())
    group.write_array(layout::support_reactions, layout::sizes(stage.support_reactions.size() / dimension, dimension),
                      stage.support_reactions);
}

void write_failure(const hdf5::Group& group, const Failure& failure, std::size_t dimension) {
  group.write_attribute("stage", std::int64_t{failure.stage});
  group.write_attribute("share", failure.share);
  if (!failure.run_out) return;
  const hdf5::Group run_out = group.create_group(layout::run_out);
  layout::for_each_attribute_of_run_out(*failure.run_out, into(run_out));
  write_stage(run_out.create_group(layout::run_out_state), failure.run_out->state, dimension);
}

} // namespace

struct ResultWriter::Impl {
  std::filesystem::path final_name;
  hdf5::File file;
  hdf5::Group stages;
  std::size_t dimension;
  std::size_t written = 0;
};

ResultWriter::ResultWriter(std::filesystem::path file, const Case& study, const std::string& solver, const Used& used) {
  check_target(file);
  hdf5::File partial = hdf5::File::create(partial_name(file));
  write_head(partial.root(), solver, to_toml(study));
  write_used(partial.root().create_group("used"), used);
  hdf5::Group stages = partial.root().create_group("stages");
  impl_ = std::make_unique<Impl>(
      Impl{std::move(file), std::move(partial), std::move(stages), static_cast<std::size_t>(used.dimension)});
}

ResultWriter::ResultWriter(ResultWriter&&) noexcept = default;
ResultWriter& ResultWriter::operator=(ResultWriter&&) noexcept = default;
ResultWriter::~ResultWriter() = default;

void ResultWriter::write(const Stage& stage) {
  write_stage(impl_->stages.create_group(layout::stage_name(impl_->written + 1)), stage, impl_->dimension);
  ++impl_->written;
}

void ResultWriter::finish(double wall_time, int threads, const std::optional<Failure>& failure) {
  const hdf5::Group& root = impl_->file.root();
  root.write_attribute("threads", std::int64_t{threads});
  root.write_attribute("wall_time", wall_time);
  if (failure) write_failure(root.create_group(layout::failure), *failure, impl_->dimension);
  root.write_attribute("status", std::string(layout::complete));
  impl_->stages = hdf5::Group({}, root.file(), "/stages");
  impl_->file.close();
  std::error_code error;
  std::filesystem::rename(partial_name(impl_->final_name), impl_->final_name, error);
  if (error)
    throw FileError({.where = impl_->final_name.string(),
                     .what = "the finished result cannot be given its name",
                     .given = error.message(),
                     .allowed = {},
                     .remedy = fmt::format("it is whole: rename {}", partial_name(impl_->final_name).string())});
}

} // namespace settle::exchange
