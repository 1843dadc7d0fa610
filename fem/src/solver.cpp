#include "settle/fem/solver.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

#include <deal.II/base/multithread_info.h>
#include <fmt/format.h>

#include "materials.hpp"
#include "pictures.hpp"
#include "point_paths.hpp"
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
  virtual std::optional<exchange::Failure> build(const StageSink& on_stage,
                                                 const std::optional<std::filesystem::path>& pictures) = 0;
};

namespace {

using Clock = std::chrono::steady_clock;

/// What the increments of one stage add up to.
struct Ramp {
  Clock::time_point start = Clock::now();
  double mass_before = 0.0;
  int increments = 0;
  unsigned linear_solves = 0;
  double reached = 0.0; ///< share of the stage
  Equilibrium last{};

  void add(Equilibrium equilibrium, double share) {
    ++increments;
    reached = share;
    last = std::move(equilibrium);
  }
};

/// Of a stage, at the end of each of its increments: equal steps, the last is 1.
std::vector<double> shares(int increments) {
  std::vector<double> shares;
  for (int i = 1; i <= increments; ++i)
    shares.push_back(static_cast<double>(i) / increments);
  return shares;
}

/// [m] or [m2]; walls keep it what it is.
double plan_area(const exchange::Geometry& geometry) {
  return geometry.dimension == 2 ? geometry.width : geometry.width * geometry.depth.value_or(geometry.width);
}

/// Of an increment, where equilibrium is not found at once: 1/64 of it is the shortest that is tried.
constexpr std::size_t increment_halvings_allowed = 6;

/// In one increment of a stage, pieces of it included.
constexpr int relaxations_allowed = 8;

/// Where flow is associated, the line search of Newton's method finds what equilibrium there is.
bool flows_otherwise_than_it_yields(const exchange::Material& material) {
  const bool frictional = material.law == exchange::Law::mohr_coulomb || material.law == exchange::Law::drucker_prager;
  return frictional && material.dilation_angle.value_or(0.0) < material.friction_angle.value_or(0.0);
}

/// How a solve failed that is not tried again.
struct Failure {
  std::string where; ///< in the course of the run
  bool halved;       ///< the increment was shortened before
  Equilibrium last;
};

constexpr const char* other_linear_solver =
    "try the other fem.linear_solver: \"multigrid\" where memory does not suffice, \"direct\" where material is "
    "next to incompressible";

exchange::NotConverged not_converged(const exchange::Case& study, const Failure& failure) {
  return exchange::NotConverged(exchange::Complaint{
      .where = study.file,
      .what = fmt::format("no equilibrium in {}{}{}", failure.where,
                          failure.halved ? ", an increment halved as often as is tried" : "",
                          failure.last.linear_solver_gave_up ? ": the linear solver gave up" : ""),
      .given = fmt::format("relative residuals {:.3g}", fmt::join(failure.last.residuals, ", ")),
      .allowed = "",
      .remedy = failure.last.linear_solver_gave_up ? other_linear_solver
                : failure.halved ? "look for material that cannot carry what is placed on it, or raise fem.increments"
                                 : "look for a Poisson's ratio next to 0.5 or a very fine mesh: both lose digits"});
}

template <int dim>
class Construction final : public Solver::Implementation {
public:
  explicit Construction(const exchange::Case& study)
      : study_(study), stages_(study.all_stages()), problem_(study), probes_(problem_, study) {}

  [[nodiscard]] exchange::Used used() const override {
    exchange::Used used = exchange::used_values(study_, study_.fem.kinematics);
    used.youngs_modulus = study_.fill().youngs_modulus;
    used.poissons_ratio = study_.fill().poissons_ratio;
    used.density = problem_.density(fill_layer());
    used.gravity = problem_.gravity();
    used.dimension = dim;
    return used;
  }

  std::optional<exchange::Failure> build(const StageSink& on_stage,
                                         const std::optional<std::filesystem::path>& pictures) override {
    std::optional<PictureSeries<dim>> series;
    if (pictures) series.emplace(*pictures);
    for (int stage = 1; stage <= study_.n_stages(); ++stage) {
      Ramp ramp{.mass_before = problem_.mass(entry(stage).layer)};
      problem_.begin(stage);
      const bool stands = raise(stage, ramp);
      if (!stands && ramp.reached == 0.0) return exchange::Failure{.stage = stage, .share = 0.0};
      if (stands) problem_.finish();
      on_stage(report(stage, ramp));
      if (series) series->add(problem_, stage);
      if (!stands) return exchange::Failure{.stage = stage, .share = ramp.reached};
    }
    return {};
  }

private:
  /// The whole stage; false where no equilibrium was found and the case may fail.
  bool raise(int stage, Ramp& ramp) {
    const std::vector<double> ends = shares(increments(stage));
    return std::all_of(ends.begin(), ends.end(), [&](double share) { return advance(share, stage, ramp); });
  }

  /// From the share of the stage reached to `target`, through halves of the way where that is too far for one
  /// increment. A solve that fails leaves the state as it was accepted last: false where the case may fail, else that
  /// ends the run.
  bool advance(double target, int stage, Ramp& ramp) {
    std::vector<double> targets{target};
    int relaxations_left = any_layer(study_, flows_otherwise_than_it_yields) ? relaxations_allowed : 0;
    while (!targets.empty()) {
      const bool shortest = targets.size() > increment_halvings_allowed;
      Equilibrium equilibrium = problem_.solve(targets.back());
      ramp.linear_solves += equilibrium.linear_solves;
      if (!equilibrium.reached() && shortest && relaxations_left-- > 0) relax(targets.back(), equilibrium, ramp);
      if (equilibrium.reached()) {
        problem_.accept();
        ramp.add(std::move(equilibrium), targets.back());
        targets.pop_back();
      } else if (problem_.formulation().linear() || shortest) {
        if (study_.construction.may_fail) return false;
        throw not_converged(study_,
                            {course(stage, ramp.reached, targets.back()), targets.size() > 1, std::move(equilibrium)});
      } else {
        targets.push_back((ramp.reached + targets.back()) / 2.0);
      }
    }
    return true;
  }

  /// Where Newton's method failed; a failure, too, leaves what that left.
  void relax(double target, Equilibrium& equilibrium, Ramp& ramp) {
    Equilibrium relaxed = problem_.relax(target);
    ramp.linear_solves += relaxed.linear_solves;
    if (relaxed.reached()) equilibrium = std::move(relaxed);
  }

  /// An increment, for messages.
  [[nodiscard]] std::string course(int stage, double from, double to) const {
    if (const std::optional<double> start = problem_.loading().time({stage, from}))
      return fmt::format("the motion between t = {:.6g} s and {:.6g} s", *start, *problem_.loading().time({stage, to}));
    const exchange::StageEntry& entry = this->entry(stage);
    if (entry.action == exchange::Action::place)
      return fmt::format("layer {} between {:.6g} and {:.6g} of its gravity", entry.layer, from, to);
    return fmt::format("stage {} (\"{}\") between {:.6g} and {:.6g} of it", stage, exchange::name_of(entry.action),
                       from, to);
  }

  [[nodiscard]] double surface_height(const exchange::SamplePoints& points) const {
    if (study_.geometry.drawn()) return highest_point(problem_);
    return std::accumulate(points.volume.begin(), points.volume.end(), 0.0) / plan_area(study_.geometry);
  }

  [[nodiscard]] const exchange::StageEntry& entry(int stage) const {
    return stages_.at(static_cast<std::size_t>(stage - 1));
  }

  /// Where nothing changes there is nothing to divide.
  [[nodiscard]] int increments(int stage) const {
    return entry(stage).action == exchange::Action::hold ? 1 : study_.fem.increments.value_or(1);
  }

  /// One of the material that is the case's first.
  [[nodiscard]] int fill_layer() const {
    for (int layer = 1; layer <= study_.construction.layers; ++layer)
      if (&study_.material_of(layer) == &study_.fill()) return layer;
    return study_.construction.layers;
  }

  [[nodiscard]] exchange::Stage report(int number, const Ramp& ramp) const {
    const int layer = entry(number).layer;
    exchange::Stage stage;
    stage.layer = layer;
    stage.steps = ramp.increments;
    stage.linear_solves = ramp.linear_solves;
    stage.out_of_balance = ramp.last.out_of_balance();
    stage.in_equilibrium = ramp.last.reached();
    stage.base_reaction = ramp.last.base_reaction;
    stage.support_reactions = ramp.last.support_reactions;
    stage.points = native_points(problem_);
    stage.probes = probes_.sample(problem_);
    for (const int present : study_.layers_present(number))
      stage.mass += problem_.mass(present);
    stage.mass_placed = problem_.mass(layer) - ramp.mass_before;
    stage.weight = (stage.mass - (1.0 - ramp.reached) * stage.mass_placed) * problem_.gravity(); // what acts
    stage.surface_height = surface_height(stage.points);
    stage.wall_time = std::chrono::duration<double>(Clock::now() - ramp.start).count();
    return stage;
  }

  exchange::Case study_;
  std::vector<exchange::StageEntry> stages_;
  StagedProblem<dim> problem_;
  ProbeLines<dim> probes_;
};

/// Single material points.
class Paths final : public Solver::Implementation {
public:
  explicit Paths(exchange::Case study) : study_(std::move(study)) {}

  [[nodiscard]] exchange::Used used() const override {
    exchange::Used used = exchange::used_values(study_, study_.fem.kinematics);
    used.youngs_modulus = study_.fill().youngs_modulus;
    used.poissons_ratio = study_.fill().poissons_ratio;
    used.density = study_.fill().density;
    used.gravity = study_.gravity;
    used.dimension = study_.geometry.dimension;
    return used;
  }
  std::optional<exchange::Failure> build(const StageSink& on_stage,
                                         const std::optional<std::filesystem::path>& /*pictures*/) override {
    follow_paths(study_, on_stage);
    return {};
  }

private:
  exchange::Case study_;
};

/// deal.II knows one number of threads in a process.
std::unique_ptr<Solver::Implementation> make_implementation(const exchange::Case& study) {
  require_solvable(study);
  dealii::MultithreadInfo::set_thread_limit(static_cast<unsigned>(study.fem.threads));
  if (study.geometry.shape == exchange::Shape::point) return std::make_unique<Paths>(study);
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

std::optional<exchange::Failure> Solver::build(const StageSink& on_stage,
                                               const std::optional<std::filesystem::path>& pictures) {
  return implementation_->build(on_stage, pictures);
}

} // namespace settle::fem
