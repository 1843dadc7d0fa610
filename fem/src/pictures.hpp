/// \file
/// Pictures for ParaView: a VTU file for each stage, a PVD file over all of them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "staged_problem.hpp"

namespace settle::fem {

/// Cells are drawn where they were placed. Fields: displacement since placement (discontinuous between cells), layer,
/// and cell means of the stress components.
template <int dim>
class PictureSeries {
public:
  /// Creates the folder where it is missing. Throws FileError.
  explicit PictureSeries(std::filesystem::path folder);

  /// Writes `stage_0001.vtu` and so on, and `stages.pvd` with all so far. Throws FileError.
  void add(const StagedProblem<dim>& problem, int stage);

private:
  std::filesystem::path folder_;
  std::vector<std::pair<double, std::string>> stages_; ///< stage number, file name
};

} // namespace settle::fem
