/// \file
/// The finite element solver as a library: a case in, one Stage after another out.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "settle/exchange/case.hpp"
#include "settle/exchange/result.hpp"

namespace settle::fem {

/// Receives each stage of construction as soon as it is in equilibrium.
using StageSink = std::function<void(const exchange::Stage&)>;

/// Staged construction at small or finite strain (docs/fem.md).
class Solver {
public:
  /// Makes the mesh, and sets the number of threads with which this process runs deal.II to `fem.threads`. Throws
  /// InputError where this solver cannot run the case (see requirements.hpp).
  explicit Solver(const exchange::Case& study);
  ~Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;

  /// The values the discrete equations hold.
  [[nodiscard]] exchange::Used used() const;

  /// Places all layers, one a stage, and hands each stage over. Call once. With `pictures` a VTU file for each stage
  /// and a PVD file of them all are written into that folder. Throws NotConverged with every residual where equilibrium
  /// is not reached, unless the case may fail: then the stage that found none, with its state in equilibrium last
  /// handed over where it has one. FileError for pictures.
  std::optional<exchange::Failure> build(const StageSink& on_stage,
                                         const std::optional<std::filesystem::path>& pictures = {});

  struct Implementation; ///< one for each dimension, in solver.cpp

private:
  std::unique_ptr<Implementation> implementation_;
};

} // namespace settle::fem
