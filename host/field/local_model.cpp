#include "host/field/local_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "host/field/parallel.h"
#include "host/field/pieces.h"

namespace isotouch::field {

namespace {

// Trials of 2026-11 on five shapes and eight scanned objects, 3,700 to 5,200 samples: 12 neighbours gave the least error (16: 3 % more, 20:
// 8 %).
constexpr std::size_t kNeighbours = 12;
static_assert(kModelled == kNeighbours + 2);
constexpr double kLeastJump = 0.1;  ///< radians: a smaller one is no edge
constexpr double kExplained = 0.1;  ///< radians: a model that is as good as this is good enough, whatever its number of pieces

constexpr double kHopeless =
    1.3;  ///< radians squared: no model is one. At 0.6 the eight scanned objects lose 20 %, without it shards stand off a hydrant's bolts

using Samples = std::vector<WeightedSample>;  ///< the sample itself first, then its neighbours by distance

/// What each patch says of each sample: it costs the same whichever joining lets it speak.
struct Predictions {
  std::size_t pieces = 0;
  std::array<std::array<double, kMaxPieces>, kNeighbours + 1> distance;
  std::array<std::array<double, kMaxPieces>, kNeighbours + 1> error;  ///< squared, weighted; none of the sample itself
  double weights = 0.0;                                               ///< of all samples but itself
  bool hopeless = false;  ///< no joining has a smaller error than `most`; then the rest is left out

  /// How far each normal is off, and the angle under which the sample seems to lie off the surface, in radians.
  Predictions(const Samples& samples, const LocalModel& model, double most) : pieces(model.count) {
    for (std::size_t j = 1; j < samples.size(); ++j) weights += samples[j].weight;
    double least = 0.0;  // if the best piece spoke for each sample
    for (std::size_t j = 0; j < samples.size() && !hopeless; ++j) {
      const double reach = (samples[j].position - samples[0].position).squaredNorm();
      for (std::size_t piece = 0; piece < pieces; ++piece) {
        const ToroidalPatch::Value value = model.pieces[piece].value(samples[j].position);
        distance[j][piece] = value.distance;
        const double off_surface = reach > 0.0 ? 4.0 * value.distance * value.distance / reach : 0.0;
        error[j][piece] = samples[j].weight * ((value.gradient - samples[j].normal).squaredNorm() + off_surface);
      }
      if (j > 0) least += *std::min_element(error[j].begin(), error[j].begin() + static_cast<std::ptrdiff_t>(pieces));
      hopeless = least > most * weights;
    }
  }
};

/// An order of the pieces and the joints between them.
struct Joining {
  std::array<std::uint8_t, kMaxPieces> order;
  std::uint8_t concave;
};

/// Every joining of `count` pieces that differs as an expression; a fourth piece is always joined last.
std::vector<Joining> joinings(std::size_t count) {
  switch (count) {
    case 1: return {{{0}, 0b0}};
    case 2: return {{{0, 1}, 0b00}, {{0, 1}, 0b10}};
    default: break;
  }
  std::vector<Joining> three = {{{0, 1, 2}, 0b000}, {{0, 1, 2}, 0b110}};
  for (const auto& order : {std::array<std::uint8_t, kMaxPieces>{1, 2, 0, 3}, {0, 2, 1, 3}, {0, 1, 2, 3}}) {
    three.push_back({order, 0b010});
    three.push_back({order, 0b100});
  }
  if (count == 3) return three;
  std::vector<Joining> four;
  for (auto joining : three) {
    joining.order[3] = 3;
    four.push_back(joining);
    joining.concave = static_cast<std::uint8_t>(joining.concave | 0b1000);
    four.push_back(joining);
  }
  return four;
}

/// The piece that speaks for `sample` under a joining.
std::size_t speaker(const Predictions& predicted, const Joining& joining, std::size_t sample) {
  const auto& distance = predicted.distance[sample];
  std::size_t chosen = joining.order[0];
  for (std::size_t k = 1; k < predicted.pieces; ++k) {
    const std::size_t next = joining.order[k];
    const double a = distance[chosen], b = distance[next];
    if ((joining.concave >> k & 1) != 0 ? b < a : b > a) chosen = next;
  }
  return chosen;
}

/// Mean square error in radians; infinite as soon as it is larger than `most`. The model must pass through its own sample.
double squared_error(const Samples& samples, const Predictions& predicted, const Joining& joining, double most) {
  double sum = 0.0;
  for (std::size_t j = 1; j < samples.size(); ++j) {
    sum += predicted.error[j][speaker(predicted, joining, j)];
    if (sum > most * predicted.weights) return std::numeric_limits<double>::infinity();
  }
  const double reach = (samples.back().position - samples[0].position).squaredNorm();
  const double own = predicted.distance[0][speaker(predicted, joining, 0)];
  return sum / predicted.weights + (reach > 0.0 ? 32.0 * own * own / reach : 0.0);
}

/// How many parameters a fit of these pieces takes from the data.
std::size_t parameters_of(const std::vector<std::size_t>& piece_of, std::size_t count) {
  std::array<std::size_t, kMaxPieces> members{};
  for (const std::size_t piece : piece_of) ++members[piece];
  std::size_t parameters = 0;
  for (std::size_t piece = 0; piece < count; ++piece) parameters += members[piece] > 2 ? 6U : members[piece] > 1 ? 5U : 3U;
  return parameters;
}

/// Every piece becomes the patch at its member nearest to the sample.
void fit_pieces(const Samples& samples, const std::vector<std::size_t>& piece_of, std::size_t count, LocalModel& model) {
  const double reach = (samples.back().position - samples[0].position).norm();
  static thread_local Samples members;  // keeps its memory
  for (std::size_t piece = 0; piece < count; ++piece) {
    members.clear();
    for (std::size_t j = 0; j < samples.size(); ++j) {
      if (piece_of[j] != piece) continue;
      auto member = samples[j];
      if (members.empty()) {
        member.weight = 1.0;
      } else {
        const double away = (member.position - members[0].position).norm() / (2.0 * reach);
        member.weight *= std::max(1e-3, 1.0 - away * away);
      }
      members.push_back(member);
    }
    model.pieces[piece] = fit_patch(members, reach);
  }
  model.count = static_cast<std::uint8_t>(count);
}

LocalModel joined(const LocalModel& model, const Joining& joining) {
  LocalModel result = model;
  for (std::size_t k = 0; k < model.count; ++k) result.pieces[k] = model.pieces[joining.order[k]];
  result.concave = joining.concave;
  return result;
}

}  // namespace

LocalModel fit_model(const std::vector<WeightedSample>& samples) {
  static const std::array<std::vector<Joining>, kMaxPieces + 1> kJoinings = {{{}, joinings(1), joinings(2), joinings(3), joinings(4)}};
  const auto equations = static_cast<double>(3 * samples.size());  // one offset and two directions a sample
  LocalModel best;
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> piece_of;
  // Generalised cross-validation: what each parameter would gain by chance is taken back.
  const auto freedom = [&](std::size_t parameters) { return std::max(1.0 - static_cast<double>(parameters) / equations, 1e-3); };
  const auto penalised = [&](double error, std::size_t parameters) {
    return (error + kExplained * kExplained) / (freedom(parameters) * freedom(parameters));
  };
  // An error that is larger gives no less than the least, also as rounded.
  const auto most_error = [&](std::size_t parameters) {
    return least * (freedom(parameters) * freedom(parameters) + 1e-9) - kExplained * kExplained;
  };
  const auto consider = [&](const LocalModel& model, std::size_t parameters) {
    const Predictions predicted(samples, model, most_error(parameters));
    if (predicted.hopeless) return;
    for (const auto& joining : kJoinings[model.count]) {
      const double error = penalised(squared_error(samples, predicted, joining, most_error(parameters)), parameters);
      if (error < least) {
        least = error;
        best = joined(model, joining);
        best.trust = 1.0 / std::sqrt(error + kExplained * kExplained);
      }
    }
  };
  LocalModel model{};
  model.count = 1;
  model.trust = 1.0;
  model.centre = samples[0].position;
  model.reach = (samples.back().position - samples[0].position).norm();
  const ToroidalPatch own_plane = fit_patch(std::span(samples).first(1), model.reach);
  std::optional<JumpTree> jumps;  // not every sample needs it
  for (std::size_t count = 1; count <= std::min(kMaxPieces, samples.size()); ++count) {
    if (count == 1) {
      piece_of.assign(samples.size(), 0);
    } else {
      const std::size_t fewest = 3 * count + (samples.size() > 2 * count ? 3U : 0U);  // one piece at least has more than two members
      if (penalised(0.0, fewest) >= least) break;
      if (!jumps) jumps.emplace(samples);
      if (jumps->jump(count - 2) < kLeastJump) break;
      jumps->split(count, piece_of);
    }
    const std::size_t parameters = parameters_of(piece_of, count);
    if (static_cast<double>(parameters) >= equations && count > 1) break;
    if (penalised(0.0, parameters) >= least) continue;  // even without an error it would not be the best
    fit_pieces(samples, piece_of, count, model);
    consider(model, parameters);
  }
  if (least >
      kHopeless) {  // nothing explains these neighbours: a bolt with one sample on it, a stray normal. The tangent plane is all that is known.
    best.count = 1;
    best.concave = 0;
    best.pieces[0] = own_plane;
  }
  return best;
}

bool is_unexplained(const LocalModel& model) {
  // As `fit_model` compares and stores it, of the least error.
  return 1.0 / (model.trust * model.trust) - kExplained * kExplained > kHopeless;
}

void fit_models(const Scan& scan, const std::vector<std::uint8_t>& known, std::vector<LocalModel>& models) {
  in_parallel(scan.size(), 64, [&](std::size_t begin, std::size_t end) {
    Samples samples;
    for (const std::uint32_t i : scan.together(begin, end)) {
      if (known[i] != 0) continue;
      const auto found = scan.around(i, kModelled);
      const double reach = found.back().squared_distance;
      samples.assign(1, {scan.positions()[i], scan.normals()[i], 1.0});
      for (const auto& f : found) {
        if (f.index == i || samples.size() > kNeighbours) continue;
        const double weight = reach > 0.0 ? std::max(1e-3, 1.0 - f.squared_distance / reach) : 1.0;
        samples.push_back({scan.positions()[f.index], scan.normals()[f.index], weight});
      }
      models[i] = fit_model(samples);
    }
  });
}

std::vector<LocalModel> local_models(const Scan& scan) {
  std::vector<LocalModel> models(scan.size());
  fit_models(scan, std::vector<std::uint8_t>(scan.size(), 0), models);
  return models;
}

}  // namespace isotouch::field
