#include "plane_bins.hpp"

#include <algorithm>
#include <cmath>

namespace settle::compare {

using exchange::PlaneBox;

namespace {

PlaneBox around(const std::vector<PlaneBox>& boxes) {
  PlaneBox all = boxes.empty() ? PlaneBox{} : boxes.front();
  for (const PlaneBox& box : boxes) {
    for (std::size_t d = 0; d < 2; ++d) {
      all.lowest[d] = std::min(all.lowest[d], box.lowest[d]);
      all.highest[d] = std::max(all.highest[d], box.highest[d]);
    }
  }
  return all;
}

} // namespace

PlaneBins::PlaneBins(const std::vector<PlaneBox>& boxes) : extent_(around(boxes)) {
  const double width = extent_.highest[0] - extent_.lowest[0], height = extent_.highest[1] - extent_.lowest[1];
  const auto most = static_cast<double>(std::max<std::size_t>(boxes.size(), 1));
  const double edge = std::max(std::sqrt(width * height / most), (width + height) / most);
  for (std::size_t d = 0; d < 2; ++d) {
    const double bins = edge > 0.0 ? (extent_.highest[d] - extent_.lowest[d]) / edge : 1.0;
    count_[d] = static_cast<std::size_t>(std::max(1.0, std::ceil(bins)));
  }
  bins_.resize(count_[0] * count_[1]);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    visit(boxes[i], [&](std::size_t bin) { bins_[bin].push_back(i); });
}

std::size_t PlaneBins::bin_along(std::size_t axis, double at) const {
  const double length = extent_.highest[axis] - extent_.lowest[axis];
  const double share = length > 0.0 ? (at - extent_.lowest[axis]) / length : 0.0;
  const auto last = static_cast<double>(count_[axis] - 1);
  return static_cast<std::size_t>(std::clamp(std::floor(share * static_cast<double>(count_[axis])), 0.0, last));
}

template <class Visit>
void PlaneBins::visit(const PlaneBox& box, const Visit& visit) const {
  for (std::size_t y = bin_along(1, box.lowest[1]); y <= bin_along(1, box.highest[1]); ++y)
    for (std::size_t x = bin_along(0, box.lowest[0]); x <= bin_along(0, box.highest[0]); ++x)
      visit(x + count_[0] * y);
}

std::vector<std::size_t> PlaneBins::near(const PlaneBox& box) const {
  std::vector<std::size_t> found;
  visit(box, [&](std::size_t bin) { found.insert(found.end(), bins_[bin].begin(), bins_[bin].end()); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

double PlaneBins::edge() const {
  const auto edge_along = [&](std::size_t d) {
    return (extent_.highest[d] - extent_.lowest[d]) / static_cast<double>(count_[d]);
  };
  return std::max(edge_along(0), edge_along(1));
}

} // namespace settle::compare
