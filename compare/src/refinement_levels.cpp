#include "settle/compare/refinement_levels.hpp"

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare {

using exchange::RefinedSize;

std::vector<std::vector<std::string>> level_overrides(const exchange::Case& study) {
  if (!study.converge) {
    throw exchange::InputError({.where = study.file,
                                .what = "the case has no table [converge], so there are no levels to run",
                                .given = {},
                                .allowed = {},
                                .remedy = "add for example [converge] with element_size = [0.25, 0.125, 0.0625] and a "
                                          "[[converge.expect]]"});
  }
  std::vector<std::vector<std::string>> levels(study.converge->levels());
  for (std::size_t i = 0; i < study.converge->element_size.size(); ++i) {
    for (const char* key : {"mpm.element_size", "fem.element_size"})
      levels[i].push_back(fmt::format("{}={}", key, study.converge->element_size[i]));
  }
  for (const auto& [key, values] : study.converge->set) {
    for (std::size_t i = 0; i < values.size(); ++i)
      levels[i].push_back(key + "=" + values[i]);
  }
  return levels;
}

double level_size(const exchange::Case& study, const std::string& solver) {
  const bool mpm = solver == "mpm";
  switch (study.converge->size) {
  case RefinedSize::element_size:
    return mpm ? study.mpm.element_size : study.fem.element_size;
  case RefinedSize::layer_thickness:
    return study.layer_thickness();
  case RefinedSize::increment:
    return 1.0 / (mpm ? study.mpm.quasi_static.increments : study.fem.increments.value_or(1));
  }
  return 0.0;
}

std::string size_title(RefinedSize size) {
  switch (size) {
  case RefinedSize::element_size:
    return "element size [m]";
  case RefinedSize::layer_thickness:
    return "thickness of a layer [m]";
  case RefinedSize::increment:
    return "increment [part of a stage]";
  }
  return {};
}

void require_finer_levels(const std::vector<exchange::Case>& levels, const std::vector<std::string>& solvers) {
  for (const std::string& solver : solvers) {
    for (std::size_t i = 1; i < levels.size(); ++i) {
      const double coarse = level_size(levels[i - 1], solver);
      const double fine = level_size(levels[i], solver);
      if (fine < coarse) continue;
      throw exchange::InputError(
          {.where = levels[i].where("converge"),
           .what = fmt::format("level {} is not finer than level {} for {}", i + 1, i, solver),
           .given = fmt::format("{}: {} after {}", size_title(levels[i].converge->size), fine, coarse),
           .allowed = "sizes from coarse to fine",
           .remedy = "vary what `size` stands for, or leave this solver out with --solvers"});
    }
  }
}

} // namespace settle::compare
