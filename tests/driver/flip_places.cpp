#include "tests/driver/flip_places.h"

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include "firmware/core/index_frame.h"

namespace isotouch::test {

namespace {

using Bytes = std::span<std::uint8_t>;
using Where = FlipPlace::Where;

constexpr int kFelt = 2;  // samples around the proxy

/// Its bytes, constant or not: a bit does not ask.
template <class T>
Bytes bytes_of(const T& value) {
  return {reinterpret_cast<std::uint8_t*>(const_cast<T*>(&value)), sizeof value};
}

/// An object's bytes without those of some of its members.
std::vector<Bytes> without(Bytes all, std::vector<Bytes> members) {
  std::sort(members.begin(), members.end(), [](Bytes a, Bytes b) { return a.data() < b.data(); });
  std::vector<Bytes> rest;
  std::uint8_t* at = all.data();
  for (const Bytes member : members) {
    if (member.data() > at) rest.emplace_back(at, member.data());
    at = member.data() + member.size();
  }
  rest.emplace_back(at, all.data() + all.size());
  return rest;
}

std::vector<Bytes> felt_bricks(const FieldView& view, const Vec3<Mm>& proxy) {
  const Vec3<Voxel> at = core::to_index(proxy, view);
  const auto index = [](Voxel x, std::int32_t size) { return std::clamp(x.raw() >> Voxel::kFractionBits, kFelt, size - 1 - kFelt); };
  const std::int32_t x = index(at.x, view.size[0]), y = index(at.y, view.size[1]), z = index(at.z, view.size[2]);
  std::vector<std::uint32_t> numbers;
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [corner](int axis) { return (corner >> axis & 1) != 0 ? kFelt : -kFelt; };
    numbers.push_back(view.brick_number(x + side(0), y + side(1), z + side(2)));
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<Bytes> bricks;
  for (const std::uint32_t number : numbers) {
    const std::int16_t* brick = view.bricks + std::size_t{number} * image_layout::kSamplesPerBrick;
    bricks.emplace_back(reinterpret_cast<std::uint8_t*>(const_cast<std::int16_t*>(brick)), 2 * image_layout::kSamplesPerBrick);
  }
  return bricks;
}

Bytes between(const void* from, const void* to) {
  return {static_cast<std::uint8_t*>(const_cast<void*>(from)), static_cast<std::uint8_t*>(const_cast<void*>(to))};
}

}  // namespace

std::vector<FlipPlace> flip_places(FaultBench& bench) {
  const core::TickState& state = bench.loop.state();
  const core::TickModel& model = bench.loop.model();
  const core::RenderState& render = state.render;
  std::vector<FlipPlace> places = {
      {"state: settings ramp", {bytes_of(state.settings), bytes_of(state.has_settings)}},
      {"state: what is felt", {bytes_of(state.felt)}},
      {"state: generation", {bytes_of(state.field_generation)}},
      {"state: reply reader", {bytes_of(state.reply)}},
      {"state: pose", {bytes_of(state.pose)}},
      {"state: motion", {bytes_of(state.motion)}},
      {"state: proxy", {bytes_of(render.proxy)}},
      {"state: spring", {bytes_of(render.spring)}},
      {"state: coupling", {bytes_of(render.coupling)}},
      {"state: friction", {bytes_of(render.friction)}},
      {"state: passivity", {bytes_of(render.passivity)}},
      {"state: supervisor", {bytes_of(state.supervisor)}},
      {"state: motor heat", {bytes_of(state.heat)}},
      {"state: last commands", {bytes_of(state.commands)}},
      {"model: device", {bytes_of(model.device)}},
      {"model: mechanism", {bytes_of(model.mechanism)}},
      {"model: motion", {bytes_of(model.motion)}},
      {"model: settings", {bytes_of(model.any_field)}},
      {"model: supervision", {bytes_of(model.supervision)}},
      {"model: motors", {bytes_of(model.motors), bytes_of(model.heat)}},
      {"loop: the rest", without(bytes_of(bench.loop), {bytes_of(state), bytes_of(model)})},
      {"command to the guard", {}, Where::kNextCommand},
      {"packet to the tick", {}, Where::kNextPacket},
      {"guard: model"},
      {"guard: the rest"},
      {"guard: memory", {}, Where::kGuardMemory},
      {"memory check", {bytes_of(bench.memory_check)}},
      {"lines, requests", {bytes_of(bench.line_state), bytes_of(bench.commands)}},
      {"watchdog", {bytes_of(bench.watch)}},
      {"driver", {bytes_of(bench.session), bytes_of(bench.port)}},
      {"field: slots, views", {bytes_of(bench.fields)}},
  };
  const std::span<const std::uint8_t> constants = bench.guard.constants();
  const Bytes guard_model{const_cast<std::uint8_t*>(constants.data()), constants.size()};
  const auto named = [&places](const char* name) -> FlipPlace& {
    return *std::find_if(places.begin(), places.end(), [name](const FlipPlace& p) { return p.name == name; });
  };
  named("guard: model").bytes = {guard_model};
  named("guard: the rest").bytes = without(bytes_of(bench.guard), {guard_model});

  const loop::ActiveField field = bench.fields.published();
  if (field.view == nullptr) return places;
  const FieldView& view = *field.view;
  const std::int16_t* const past_bricks = view.bricks + std::size_t{view.brick_count} * image_layout::kSamplesPerBrick;
  const std::vector<Bytes> felt = felt_bricks(view, bench.last.out.proxy);
  places.push_back({"field: header", {between(view.image.data(), view.root)}});
  places.push_back({"field: tables", {between(view.root, view.bricks)}});
  places.push_back({"field: bricks, felt", felt});
  places.push_back({"field: bricks, others", without(between(view.bricks, past_bricks), felt)});
  places.push_back({"field: stiffness", {between(view.stiffness_parts, view.stiffness_parts + view.brick_count)}});
  return places;
}

int guard_memory_file() {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", none)) {
    if (std::filesystem::read_symlink(entry.path(), none).string().find("isotouch-guard") != std::string::npos)
      return std::stoi(entry.path().filename().string());
  }
  return -1;
}

void flip(FaultBench& bench, const FlipPlace& place, std::uint64_t number) {
  const auto change = [](std::uint8_t* byte, std::uint64_t bit) {
    volatile std::uint8_t* const at = byte;  // also where the compiler believes it to be constant
    *at = static_cast<std::uint8_t>(*at ^ 1U << bit % 8);
  };
  auto once = [change, number, done = false](Bytes bytes) mutable {
    const std::uint64_t bit = number % (8 * bytes.size());
    if (!done) change(bytes.data() + bit / 8, bit);
    done = true;
  };
  switch (place.where) {
    case Where::kMemory: {
      std::size_t bits = 0;
      for (const Bytes bytes : place.bytes) bits += 8 * bytes.size();
      std::uint64_t left = number % bits;
      for (const Bytes bytes : place.bytes) {
        if (left < 8 * bytes.size()) return change(bytes.data() + left / 8, left);
        left -= 8 * bytes.size();
      }
      break;
    }
    case Where::kGuardMemory: {
      const std::uint64_t bit = number % (8 * sizeof(guard::Memory));
      std::uint8_t byte = 0;
      const int file = guard_memory_file();
      if (pread(file, &byte, 1, static_cast<off_t>(bit / 8)) != 1) break;
      change(&byte, bit);
      static_cast<void>(pwrite(file, &byte, 1, static_cast<off_t>(bit / 8)) == 1);
      break;
    }
    case Where::kNextCommand: bench.tamper = [once](loop::Command& command) mutable { once(bytes_of(command)); }; break;
    case Where::kNextPacket: bench.garble = [once](loop::Sample& sample) mutable { once(bytes_of(sample)); }; break;
  }
}

}  // namespace isotouch::test
