#include "level_ground.hpp"

#include <algorithm>
#include <limits>

namespace settle::fem {

LevelGround::LevelGround(const exchange::Case& study) {
  for (const exchange::StageEntry& entry : study.all_stages()) {
    if (entry.action != exchange::Action::ground) break; // ground comes before everything else
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Stratum stratum{entry.layer, infinity, -infinity, study.material_of(entry.layer).density * study.gravity, entry.k0};
    for (const exchange::Polygon& polygon : study.geometry.polygons) {
      if (polygon.layer != entry.layer) continue;
      for (const std::vector<double>& corner : polygon.corners) {
        stratum.bottom = std::min(stratum.bottom, corner[1]);
        stratum.top = std::max(stratum.top, corner[1]);
      }
    }
    strata_.push_back(stratum);
  }
}

template <int dim>
std::optional<dealii::SymmetricTensor<2, 3>> LevelGround::stress(int layer, double height, int stages) const {
  const auto stratum = std::find_if(strata_.begin(), strata_.end(),
                                    [layer](const Stratum& candidate) { return candidate.layer == layer; });
  if (stratum == strata_.end() || !stratum->k0) return {};
  const double vertical = -overburden(height, stages);
  dealii::SymmetricTensor<2, 3> stress = *stratum->k0 * vertical * dealii::unit_symmetric_tensor<3>();
  stress[dim - 1][dim - 1] = vertical;
  return stress;
}

double LevelGround::overburden(double height, int stages) const {
  double weight = 0.0;
  const auto placed = std::min(static_cast<std::size_t>(stages), strata_.size());
  for (std::size_t i = 0; i < placed; ++i) {
    const Stratum& stratum = strata_[i];
    weight += stratum.unit_weight * std::max(stratum.top - std::max(height, stratum.bottom), 0.0);
  }
  return weight;
}

template std::optional<dealii::SymmetricTensor<2, 3>> LevelGround::stress<2>(int, double, int) const;
template std::optional<dealii::SymmetricTensor<2, 3>> LevelGround::stress<3>(int, double, int) const;

} // namespace settle::fem
