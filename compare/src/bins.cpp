#include "bins.hpp"

#include <algorithm>
#include <cmath>

namespace settle::compare {
namespace {

constexpr std::size_t axes = 3;

Box around(const std::vector<Box>& boxes) {
  Box all = boxes.empty() ? Box{} : boxes.front();
  for (const Box& box : boxes) {
    for (std::size_t d = 0; d < axes; ++d) {
      all.lowest[d] = std::min(all.lowest[d], box.lowest[d]);
      all.highest[d] = std::max(all.highest[d], box.highest[d]);
    }
  }
  return all;
}

/// Of bins of which `n` fill a box of extents a, b, c, also where it is flat or thin [m].
double edge_of_bins(double a, double b, double c, double n) {
  return std::max({std::cbrt(a * b * c / n), std::sqrt((a * b + b * c + c * a) / n), (a + b + c) / n});
}

} // namespace

Bins::Bins(const std::vector<Box>& boxes) : all_(around(boxes)) {
  const auto most = static_cast<double>(std::max<std::size_t>(boxes.size(), 1));
  const double edge = edge_of_bins(extent(0), extent(1), extent(2), most);
  for (std::size_t d = 0; d < axes; ++d)
    count_[d] = static_cast<std::size_t>(std::max(1.0, edge > 0.0 ? std::ceil(extent(d) / edge) : 1.0));
  bins_.resize(count_[0] * count_[1] * count_[2]);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    visit(boxes[i], [&](std::size_t bin) { bins_[bin].push_back(i); });
}

std::size_t Bins::bin_along(std::size_t axis, double at) const {
  const double share = extent(axis) > 0.0 ? (at - all_.lowest[axis]) / extent(axis) : 0.0;
  const auto last = static_cast<double>(count_[axis] - 1);
  return static_cast<std::size_t>(std::clamp(std::floor(share * static_cast<double>(count_[axis])), 0.0, last));
}

template <class Visit>
void Bins::visit(const Box& box, const Visit& visit) const {
  std::array<std::size_t, axes> first{}, last{};
  for (std::size_t d = 0; d < axes; ++d) {
    first[d] = bin_along(d, box.lowest[d]);
    last[d] = bin_along(d, box.highest[d]);
  }
  for (std::size_t k = first[2]; k <= last[2]; ++k)
    for (std::size_t j = first[1]; j <= last[1]; ++j)
      for (std::size_t i = first[0]; i <= last[0]; ++i)
        visit(i + count_[0] * (j + count_[1] * k));
}

std::vector<std::size_t> Bins::near(const Box& box) const {
  std::vector<std::size_t> found;
  visit(box, [&](std::size_t bin) { found.insert(found.end(), bins_[bin].begin(), bins_[bin].end()); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

double Bins::edge() const {
  double longest = 0.0;
  for (std::size_t d = 0; d < axes; ++d)
    longest = std::max(longest, extent(d) / static_cast<double>(count_[d]));
  return longest;
}

} // namespace settle::compare
