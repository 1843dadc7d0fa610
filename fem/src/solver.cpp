#include "settle/fem/solver.hpp"

#include <chrono>
#include <vector>

#include <fmt/format.h>

#include "pictures.hpp"
#include "sampling.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/fem/requirements.hpp"
#include "staged_problem.hpp"

namespace settle::fem {

struct Solver::Implementation {
  Implementation() = default;
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;
  virtual ~Implementation() = default;
  [[nodiscard]] virtual exchange::Used used() const = 0;
  virtual void build(const StageSink& on_stage, const std::optional<std::filesystem::path>& pictures) = 0;
};

namespace {

using Clock = std::chrono::steady_clock;

/// What the increments of one stage add up to.
struct Ramp {
  Clock::time_point start = Clock::now();
  int increments = 0;
  unsigned linear_solves = 0;
  Equilibrium last;

  void add(Equilibrium equilibrium) {
    ++increments;
    linear_solves += equilibrium.linear_solves();
    last = std::move(equilibrium);
  }
};

/// The factors of the gravity ramp: equal steps, the last is 1.
std::vector<double> gravity_factors(int increments) {
  std::vector<double> factors;
  for (int i = 1; i <= increments; ++i)
    factors.push_back(static_cast<double>(i) / increments);
  return factors;
}

exchange::NotConverged not_converged(const exchange::Case& study, int layer, double factor,
                                     const Equilibrium& equilibrium) {
  return exchange::NotConverged(
      exchange::Complaint{.where = study.file,
                          .what = fmt::format("no equilibrium in layer {} at {:.6g} of its gravity", layer, factor),
                          .given = fmt::format("relative residuals {:.3g}", fmt::join(equilibrium.residuals, ", ")),
                          .allowed = "",
                          .remedy = "look for a Poisson's ratio next to 0.5 or a very fine mesh: both lose digits"});
}

template <int dim>
class Construction final : public Solver::Implementation {
public:
  explicit Construction(const exchange::Case& study) : study_(study), problem_(study), probes_(problem_, study) {}

  [[nodiscard]] exchange::Used used() const override {
    exchange::Used used = exchange::used_values(study_, exchange::Kinematics::small);
    used.youngs_modulus = problem_.law().youngs_modulus;
    used.poissons_ratio = problem_.law().poissons_ratio;
    used.density = problem_.density();
    used.gravity = problem_.gravity();
    used.dimension = dim;
    return used;
  }

  void build(const StageSink& on_stage, const std::optional<std::filesystem::path>& pictures) override {
    std::optional<PictureSeries<dim>> series;
    if (pictures) series.emplace(*pictures);
    for (int layer = 1; layer <= study_.construction.layers; ++layer) {
      Ramp ramp;
      problem_.activate(layer);
      for (const double factor : gravity_factors(study_.fem.increments.value_or(1))) {
        Equilibrium equilibrium = problem_.solve(factor);
        if (!equilibrium.reached()) throw not_converged(study_, layer, factor, equilibrium);
        problem_.accept();
        ramp.add(std::move(equilibrium));
      }
      on_stage(report(layer, ramp));
      if (series) series->add(problem_, layer);
    }
  }

private:
  [[nodiscard]] exchange::Stage report(int layer, const Ramp& ramp) const {
    exchange::Stage stage;
    stage.layer = layer;
    stage.steps = ramp.increments;
    stage.linear_solves = ramp.linear_solves;
    stage.out_of_balance = ramp.last.out_of_balance();
    stage.in_equilibrium = ramp.last.reached();
    stage.base_reaction = ramp.last.base_reaction;
    stage.points = native_points(problem_);
    stage.probes = probes_.sample(problem_);
    for (std::size_t i = 0; i < stage.points.size(); ++i) {
      const double mass = problem_.density() * stage.points.volume[i]; // the volume as placed: geometry is frozen
      stage.mass += mass;
      if (stage.points.layer[i] == layer) stage.mass_placed += mass;
    }
    stage.weight = stage.mass * problem_.gravity();
    stage.surface_height = layer * study_.layer_thickness();
    stage.wall_time = std::chrono::duration<double>(Clock::now() - ramp.start).count();
    return stage;
  }

  exchange::Case study_;
  StagedProblem<dim> problem_;
  ProbeLines<dim> probes_;
};

std::unique_ptr<Solver::Implementation> make_implementation(const exchange::Case& study) {
  require_solvable(study);
  if (study.geometry.dimension == 3) return std::make_unique<Construction<3>>(study);
  return std::make_unique<Construction<2>>(study);
}

} // namespace

Solver::Solver(const exchange::Case& study) : implementation_(make_implementation(study)) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

exchange::Used Solver::used() const {
  return implementation_->used();
}

void Solver::build(const StageSink& on_stage, const std::optional<std::filesystem::path>& pictures) {
  implementation_->build(on_stage, pictures);
}

} // namespace settle::fem
