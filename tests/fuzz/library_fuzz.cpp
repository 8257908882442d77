/// The functions of C, called in any order with any arguments: each gives a status, and none crashes.
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "host/library/isotouch.h"
#include "tests/fuzz/input.h"
#include "tests/support/field_image.h"

using namespace isotouch;

namespace {

const std::vector<std::uint8_t>& ball() {
  static const std::vector<std::uint8_t> bytes = test::FieldImage({24, 24, 24}, [](const test::Point& p) {
                                                   return length(p - test::Point{12, 12, 12}) - 5;
                                                 }).bytes();
  return bytes;
}

/// Mostly a place near the ball or a setting; now and then something that is none.
double number(fuzz::Front& front) {
  const auto raw = front.take<std::int16_t>();
  if (raw == 0x7FFF) return std::numeric_limits<double>::quiet_NaN();
  if (raw == 0x7FFE) return std::numeric_limits<double>::infinity();
  if (raw == 0x7FFD) return -1e300;
  return raw / 1024.0;
}

/// A file that the functions write and read; now and then a name that is none.
const char* file_name(std::uint8_t which) {
  static const std::string own = "/tmp/isotouch-fuzz-" + std::to_string(::getpid()) + ".file";
  switch (which % 16) {
    case 0: return nullptr;
    case 1: return "";
    case 2: return "/nowhere/file";
    case 3: return "/tmp/.";
    default: return own.c_str();
  }
}

const char* column(fuzz::Front& front) {
  const auto which = front.take<std::uint8_t>();
  std::uint32_t is_integer = 2;
  const char* name = isotouch_trace_column(which, &is_integer);
  fuzz::hold((name != nullptr) == (which < isotouch_trace_columns()), "columns have names as far as they go");
  fuzz::hold(name == nullptr || is_integer <= 1, "a column is of whole numbers or not");
  return which == 254 ? "nothing" : name;
}

/// What a handle of any kind says of itself.
isotouch_status describe(std::uint64_t handle, std::uint8_t what) {
  isotouch_field_facts field{};
  isotouch_trace_facts trace{};
  if (what % 2 == 0) {
    const isotouch_status status = isotouch_field_describe(handle, &field, what < 250 ? sizeof field : what);
    fuzz::hold(status != ISOTOUCH_OK || (field.samples[0] > 0 && field.voxel_mm > 0), "a field has its numbers");
    return status;
  }
  const isotouch_status status = isotouch_trace_describe(handle, &trace, what < 250 ? sizeof trace : what);
  fuzz::hold(status != ISOTOUCH_OK || trace.ticks <= 100'000, "a trace has no more ticks than were felt");
  return status;
}

/// What asks no handle.
isotouch_status say(std::uint8_t what) {
  switch (what % 4) {
    case 0: fuzz::hold(isotouch_version()[0] != 0, "the library has a version"); return ISOTOUCH_OK;
    case 1: fuzz::hold(isotouch_state_name(what)[0] != 0, "every number of a state has a name"); return ISOTOUCH_OK;
    case 2: {
      isotouch_settings settings{};
      return isotouch_settings_default(what < 128 ? &settings : nullptr, what < 250 ? sizeof settings : what);
    }
    default: {
      const char* sentence = what < 128 ? "somebody says so" : nullptr;
      fuzz::hold(isotouch_fail(ISOTOUCH_BAD_DATA, sentence) == ISOTOUCH_BAD_DATA, "a failure that is set is returned");
      fuzz::hold((isotouch_last_error()[0] != 0) == (sentence != nullptr), "the sentence that is set is the last one, and none is empty");
      return ISOTOUCH_OK;
    }
  }
}

/// Connections to nobody; to somebody who answers is for the door `link`.
isotouch_status connect(std::uint8_t what, std::uint64_t* controller) {
  const char* addresses[] = {nullptr, "", "unix:", "unix:/nowhere/control", "tcp:1", "ssh://", "ssh:/x", "unix:\n"};
  return isotouch_controller_connect(addresses[what % 8], what / 8, controller);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Front front(data, size);
  ::unlink(file_name(4));
  std::array<std::uint64_t, 6> handles{};  // some are freed and used all the same
  for (int call = 0; call < 64 && !front.empty(); ++call) {
    const auto what = front.take<std::uint8_t>();
    std::uint64_t& one = handles[front.take<std::uint8_t>() % handles.size()];
    const std::size_t size_of_felt = what < 200 ? sizeof(isotouch_felt) : what;
    isotouch_felt felt{};
    isotouch_status status = ISOTOUCH_OK;
    switch (what % 20) {
      case 0: status = isotouch_field_read(ball().data(), ball().size(), &one); break;
      case 1: {
        std::uint64_t& other = handles[front.take<std::uint8_t>() % handles.size()];
        isotouch_settings settings{};
        isotouch_settings_default(&settings, sizeof settings);
        settings.record_ticks = front.take<std::uint8_t>();
        settings.friction = number(front), settings.hand_damping = number(front), settings.stiffness = number(front);
        status = isotouch_touch_new(one, &settings, sizeof settings, &other);
        break;
      }
      case 2: {
        const double hip[3] = {number(front), number(front), number(front)};
        status = isotouch_touch_position(one, hip, what / 16, &felt, size_of_felt);
        break;
      }
      case 3: {
        const std::int32_t counts[3] = {front.take<std::int16_t>(), front.take<std::int16_t>(), front.take<std::int32_t>()};
        status = isotouch_touch_counts(one, counts, what % 9, 0, &felt, size_of_felt);
        break;
      }
      case 4: status = isotouch_touch_missed(one, &felt, size_of_felt); break;
      case 5: status = isotouch_touch_request(one, what % 5); break;
      case 6: {
        const double points[6] = {number(front), number(front), number(front), number(front), number(front), number(front)};
        double distance[2], gradient[6];
        status = isotouch_field_sample(one, what % 3, points, distance, gradient, nullptr, nullptr);
        break;
      }
      case 7: {
        double value = 0;
        status = isotouch_trace_doubles(one, "tick", front.take<std::uint64_t>(), 1, &value);
        break;
      }
      case 8: status = isotouch_free(one); break;
      case 9: one = front.take<std::uint64_t>(); break;
      case 10: status = isotouch_field_load(file_name(front.take<std::uint8_t>()), &one); break;
      case 11: status = isotouch_field_save(one, file_name(front.take<std::uint8_t>())); break;
      case 12: status = describe(one, front.take<std::uint8_t>()); break;
      case 13: {
        const std::size_t count = front.take<std::uint8_t>() % 32;
        std::vector<double> path(3 * count);
        for (double& each : path) each = number(front);
        std::vector<isotouch_felt> all(count);
        status = isotouch_touch_path(one, count, path.data(), all.data(), count * sizeof(isotouch_felt) + (what >= 240 ? 1 : 0));
        for (const isotouch_felt& each : all) fuzz::hold(std::isfinite(each.force_n[1]), "a force is a number");
        break;
      }
      case 14: {
        std::uint64_t ticks = 0;
        status = isotouch_touch_save(one, file_name(front.take<std::uint8_t>()), what < 128 ? &ticks : nullptr);
        break;
      }
      case 15: status = isotouch_trace_load(file_name(front.take<std::uint8_t>()), &one); break;
      case 16: {
        std::array<std::int64_t, 4> values{};
        const char* name = column(front);
        const auto first = front.take<std::uint8_t>();
        status = isotouch_trace_integers(one, name, first < 250 ? first : ~std::uint64_t{0}, what < 200 ? what % 5 : ~std::size_t{0},
                                         values.data());
        break;
      }
      case 17: {
        std::array<double, 4> values{};
        const char* name = column(front);
        const auto first = front.take<std::uint8_t>();
        status = isotouch_trace_doubles(one, name, first < 250 ? first : ~std::uint64_t{0}, what < 200 ? what % 5 : ~std::size_t{0},
                                        values.data());
        break;
      }
      case 18: status = say(front.take<std::uint8_t>()); break;
      case 19: status = connect(front.take<std::uint8_t>(), &one); break;
    }
    fuzz::hold(status >= ISOTOUCH_OK && status <= ISOTOUCH_NO_MEMORY, "every call has a status that is no mistake of the library");
    fuzz::hold(status == ISOTOUCH_OK || isotouch_last_error()[0] != 0, "every failure has a sentence");
    fuzz::hold(status != ISOTOUCH_OK || std::isfinite(felt.force_n[0]), "a force is a number");
  }
  for (const std::uint64_t handle : handles) isotouch_free(handle);
  fuzz::hold(!std::filesystem::exists(std::string(file_name(4)) + ".part"), "no file is left half written");
  return 0;
}
