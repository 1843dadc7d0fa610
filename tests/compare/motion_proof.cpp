#include "motion_proof.hpp"

#include <algorithm>
#include <initializer_list>

#include "motion_calculus.hpp"
#include "motion_samples.hpp"

namespace settle::compare::test {
namespace {

using exchange::FormulaPoint;
using exchange::Held;

constexpr std::size_t x_axis = 0, y_axis = 1;

Vector position_of(const FormulaPoint& at) {
  return {at.x, at.y};
}

FormulaPoint moved(FormulaPoint at, const Vector& position) {
  at.x = position[x_axis];
  at.y = position[y_axis];
  return at;
}

class Proof {
public:
  explicit Proof(const exchange::Case& study)
      : study_(study), formulas_(study), sampler_(study), in_time_(study.motion->duration.has_value()),
        step_(1e-3 * std::max(study.geometry.width, study.geometry.height)) {}

  std::vector<Finding> run(int points) {
    know_whether_layers_matter(points);
    for (int i = 0; i < points; ++i) {
      const FormulaPoint at = sampler_.inside();
      scale_with(at);
      check_stress(at);
      check_momentum(at);
      if (in_time_) check_time(at);
      check_edge(sampler_.on_edge());
    }
    return findings();
  }

private:
  const exchange::Case& study_;
  exchange::Formulas formulas_;
  Sampler sampler_;
  bool in_time_;
  double step_;              ///< of differences in space [m]
  bool thin_layers_ = false; ///< the motion does not know its layers: it is the limit of thin ones
  Comparison stress_{"stress is that of the displacement"};
  Comparison momentum_{"momentum is balanced"};
  Comparison velocity_{"velocity is the rate of displacement"};
  Comparison acceleration_{"acceleration is the rate of velocity"};
  Comparison start_displacement_{"displacement starts from zero"};
  Comparison start_stress_{"stress starts from zero"};
  Comparison free_faces_{free_faces};
  Comparison held_{held};
  Comparison joined_{"layers stay joined"};
  Comparison tractions_{"layers press on each other alike"};

  void know_whether_layers_matter(int points) {
    if (study_.construction.layers == 1) return;
    thin_layers_ = true;
    for (int i = 0; i < points; ++i) {
      FormulaPoint at = sampler_.inside();
      const Vector own = formulas_.displacement(at);
      at.layer = at.layer == 1 ? 2 : 1;
      if (formulas_.displacement(at) != own) thin_layers_ = false;
    }
  }

  Matrix displacement_gradient(const FormulaPoint& at, double step) {
    return gradient([&](const Vector& x) { return formulas_.displacement(moved(at, x)); }, position_of(at), step);
  }

  /// Of the current configuration; with small strain that is the placed one.
  Matrix deformation(const FormulaPoint& at, double step) {
    Matrix result{};
    if (in_time_) result = displacement_gradient(at, step);
    result[0][0] += 1;
    result[1][1] += 1;
    return result;
  }

  /// Limits of thin layers accumulate strain from where the surface passed: only what one more layer adds is elastic.
  void check_stress(const FormulaPoint& at) {
    if (thin_layers_) return check_stress_of_next_layer(at);
    const auto of_law = [&](double step) {
      return in_time_ ? finite_stress(study_.fill(), deformation(at, step))
                      : linear_stress(study_.fill(), displacement_gradient(at, step));
    };
    stress_.add(of_law(step_), of_law(step_ / 2), formulas_.stress(at));
  }

  void check_stress_of_next_layer(const FormulaPoint& at) {
    if (at.stage == study_.construction.layers) return;
    FormulaPoint next = at;
    ++next.stage;
    const auto of_law = [&](double step) {
      return linear_stress(study_.fill(), displacement_gradient(next, step)) -
             linear_stress(study_.fill(), displacement_gradient(at, step));
    };
    stress_.add(of_law(step_), of_law(step_ / 2), formulas_.stress(next) - formulas_.stress(at));
  }

  /// Div P + rho (g + b - a) = 0
  void check_momentum(const FormulaPoint& at) {
    const double rho = study_.fill().density;
    const auto of_stress = [&](double step) {
      return divergence(
          [&](const Vector& x) {
            const FormulaPoint there = moved(at, x);
            return nominal(formulas_.stress(there), deformation(there, step));
          },
          position_of(at), step);
    };
    const Vector inertia = formulas_.acceleration(at) - formulas_.body_force(at) - Vector{0.0, -study_.gravity};
    momentum_.add(of_stress(step_), of_stress(step_ / 2), rho * inertia);
  }

  void check_time(const FormulaPoint& at) {
    const double step = 1e-3 * *study_.motion->duration;
    const auto later = [&](double time) {
      FormulaPoint then = at;
      then.time += time;
      return then;
    };
    const auto displacement = [&](double s) { return formulas_.displacement(later(s)); };
    const auto velocity = [&](double s) { return formulas_.velocity(later(s)); };
    velocity_.add(derivative(displacement, step), derivative(displacement, step / 2), formulas_.velocity(at));
    acceleration_.add(derivative(velocity, step), derivative(velocity, step / 2), formulas_.acceleration(at));
    start_displacement_.add(formulas_.displacement(later(-at.time)), Vector{});
    start_stress_.add(formulas_.stress(later(-at.time)), Stress{});
  }

  /// What is small on the boundary is so beside the motion as a whole, and forces beside stress over the body's size.
  void scale_with(const FormulaPoint& at) {
    const double displacement = magnitude(formulas_.displacement(at)), stress = magnitude(formulas_.stress(at));
    momentum_.scale_with(stress / std::max(study_.geometry.width, study_.geometry.height));
    for (Comparison* comparison : {&start_displacement_, &held_, &joined_})
      comparison->scale_with(displacement);
    for (Comparison* comparison : {&start_stress_, &free_faces_, &tractions_})
      comparison->scale_with(stress);
  }

  void check_edge(const EdgePoint& edge) {
    if (edge.neighbour)
      check_interface(edge, *edge.neighbour);
    else
      check_boundary(edge);
  }

  void check_boundary(const EdgePoint& edge) {
    const bool free_in_x = !edge.support || edge.support->held == Held::y;
    const bool free_in_y = !edge.support || edge.support->held == Held::x;
    const Vector force = nominal_traction(edge.at, edge.normal), motion = formulas_.displacement(edge.at);
    if (free_in_x || free_in_y)
      free_faces_.add(Vector{free_in_x ? force[x_axis] : 0, free_in_y ? force[y_axis] : 0}, Vector{});
    if (edge.support && edge.support->motion == exchange::SupportMotion::none)
      held_.add(Vector{free_in_x ? 0 : motion[x_axis], free_in_y ? 0 : motion[y_axis]}, Vector{});
    const bool just_placed = edge.at.stage == edge.at.layer;
    if (thin_layers_ && !edge.support && just_placed) start_displacement_.add(motion, Vector{});
  }

  void check_interface(const EdgePoint& edge, int neighbour) {
    FormulaPoint other = edge.at;
    other.layer = neighbour;
    joined_.add(increment(edge.at), increment(other));
    tractions_.add(traction(formulas_.stress(edge.at), edge.normal), traction(formulas_.stress(other), edge.normal));
  }

  /// What the stage of `at` adds to the displacement; all of it where the point was placed in that stage.
  Vector increment(const FormulaPoint& at) {
    const Vector now = formulas_.displacement(at);
    if (at.stage == at.layer) return now;
    FormulaPoint before = at;
    --before.stage;
    return now - formulas_.displacement(before);
  }

  /// Per area as placed.
  Vector nominal_traction(const FormulaPoint& at, const Vector& normal) {
    const Matrix P = nominal(formulas_.stress(at), deformation(at, step_));
    return {P[0][0] * normal[0] + P[0][1] * normal[1], P[1][0] * normal[0] + P[1][1] * normal[1]};
  }

  [[nodiscard]] std::vector<Finding> findings() const {
    std::vector<Finding> all{stress_.finding(), momentum_.finding()};
    const auto report = [&all](std::initializer_list<const Comparison*> comparisons) {
      for (const Comparison* comparison : comparisons)
        all.push_back(comparison->finding());
    };
    if (in_time_) report({&velocity_, &acceleration_, &start_displacement_, &start_stress_});
    if (thin_layers_) report({&start_displacement_});
    if (study_.construction.layers > 1) report({&joined_, &tractions_});
    for (const Comparison* boundary :
         {&free_faces_, &held_}) // supports may leave nothing free, or all follow the motion
      if (boundary->finding().compared > 0) report({boundary});
    return all;
  }
};

} // namespace

std::vector<Finding> prove(const exchange::Case& study, int points) {
  return Proof(study).run(points);
}

} // namespace settle::compare::test
