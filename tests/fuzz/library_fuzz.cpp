/// The functions of C, called in any order with any arguments: each gives a status, and none crashes.
#include <array>
#include <cmath>
#include <limits>
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Front front(data, size);
  std::array<std::uint64_t, 6> handles{};  // some are freed and used all the same
  for (int call = 0; call < 64 && !front.empty(); ++call) {
    const auto what = front.take<std::uint8_t>();
    std::uint64_t& one = handles[front.take<std::uint8_t>() % handles.size()];
    const std::size_t size_of_felt = what < 200 ? sizeof(isotouch_felt) : what;
    isotouch_felt felt{};
    isotouch_status status = ISOTOUCH_OK;
    switch (what % 10) {
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
    }
    fuzz::hold(status >= ISOTOUCH_OK && status <= ISOTOUCH_NO_MEMORY, "every call has a status that is no mistake of the library");
    fuzz::hold(status == ISOTOUCH_OK || isotouch_last_error()[0] != 0, "every failure has a sentence");
    fuzz::hold(status != ISOTOUCH_OK || std::isfinite(felt.force_n[0]), "a force is a number");
  }
  for (const std::uint64_t handle : handles) isotouch_free(handle);
  return 0;
}
