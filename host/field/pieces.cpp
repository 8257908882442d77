#include "host/field/pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/field/sets.h"

namespace isotouch::field {

namespace {

double jump_between(const WeightedSample& a, const WeightedSample& b) {
  const Eigen::Vector3d step = b.position - a.position;
  const double length = step.norm();
  const double asymmetry = length > 0.0 ? std::abs((a.normal + b.normal).dot(step)) / length : 0.0;
  return (a.normal - b.normal).norm() + asymmetry;
}

}  // namespace

JumpTree::JumpTree(std::span<const WeightedSample> samples) : samples_(samples.size()) {
  // Grown from the first sample: of each other one, the smallest jump to those that are joined.
  struct Way {
    Edge edge;
    std::size_t to;
  };
  std::vector<Way> ways;
  ways.reserve(samples.size() - 1);
  for (std::size_t b = 1; b < samples.size(); ++b) ways.push_back({{jump_between(samples[0], samples[b]), 0, b}, b});
  edges_.reserve(ways.size());
  while (!ways.empty()) {
    const auto least = std::min_element(ways.begin(), ways.end(), [](const Way& v, const Way& w) { return v.edge < w.edge; });
    const std::size_t joined = least->to;
    edges_.push_back(least->edge);
    *least = ways.back();
    ways.pop_back();
    for (Way& way : ways) {
      const std::size_t a = std::min(joined, way.to), b = std::max(joined, way.to);
      way.edge = std::min(way.edge, Edge{jump_between(samples[a], samples[b]), a, b});
    }
  }
  std::sort(edges_.begin(), edges_.end());
}

void JumpTree::split(std::size_t count, std::vector<std::size_t>& piece_of) const {
  Sets sets(samples_);
  for (std::size_t k = 0; k + count < samples_; ++k) {
    sets.join(sets.of(static_cast<std::uint32_t>(edges_[k].b)), sets.of(static_cast<std::uint32_t>(edges_[k].a)));
  }
  std::vector<std::size_t> number(samples_, samples_);
  std::size_t next = 0;
  piece_of.resize(samples_);
  for (std::size_t i = 0; i < samples_; ++i) {
    auto& n = number[sets.of(static_cast<std::uint32_t>(i))];
    if (n == samples_) n = next++;
    piece_of[i] = n;
  }
}

}  // namespace isotouch::field
