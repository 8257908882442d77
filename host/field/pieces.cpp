#include "host/field/pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isotouch::field {

namespace {

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t a) {
  while (parent[a] != a) a = parent[a] = parent[parent[a]];
  return a;
}

double jump_between(const WeightedSample& a, const WeightedSample& b) {
  const Eigen::Vector3d step = b.position - a.position;
  const double length = step.norm();
  const double asymmetry = length > 0.0 ? std::abs((a.normal + b.normal).dot(step)) / length : 0.0;
  return (a.normal - b.normal).norm() + asymmetry;
}

}  // namespace

JumpTree::JumpTree(std::span<const WeightedSample> samples) : samples_(samples.size()) {
  std::vector<Edge> all;
  all.reserve(samples.size() * (samples.size() - 1) / 2);
  for (std::size_t a = 0; a < samples.size(); ++a) {
    for (std::size_t b = a + 1; b < samples.size(); ++b) all.push_back({jump_between(samples[a], samples[b]), a, b});
  }
  std::sort(all.begin(), all.end());
  std::vector<std::size_t> parent(samples.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (const auto& edge : all) {
    const std::size_t a = root_of(parent, edge.a), b = root_of(parent, edge.b);
    if (a == b) continue;
    parent[a] = b;
    edges_.push_back(edge);
  }
}

void JumpTree::split(std::size_t count, std::vector<std::size_t>& piece_of) const {
  std::vector<std::size_t> parent(samples_);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (std::size_t k = 0; k + count < samples_; ++k) parent[root_of(parent, edges_[k].a)] = root_of(parent, edges_[k].b);
  std::vector<std::size_t> number(samples_, samples_);
  std::size_t next = 0;
  piece_of.resize(samples_);
  for (std::size_t i = 0; i < samples_; ++i) {
    auto& n = number[root_of(parent, i)];
    if (n == samples_) n = next++;
    piece_of[i] = n;
  }
}

}  // namespace isotouch::field
