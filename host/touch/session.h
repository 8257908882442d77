/// A hand without a device on a field: what the browser's page runs, in the same integers as the controller.
///
/// Numbers come and go as doubles in the units of the tables, because the page has no others. They become fixed point here, once, and everything behind is
/// the core. A trace that the session keeps holds the integers, so `isotouch replay --check` answers it to the bit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/core/render.h"
#include "host/touch/hand_work.h"
#include "shared/device_model.h"
#include "shared/field_view.h"
#include "shared/tick_io.h"
#include "shared/trace.h"

namespace isotouch::touch {

/// Why something was refused, in the core of a sentence; nullptr when nothing was. The caller adds file and place. Nothing is changed by what is refused.
using Refused = const char*;

/// Workspace frame: x right, y up, z towards the person, mm.
using Place = std::array<double, 3>;

/// What one tick felt.
struct Felt {
  Place hip{};                  ///< mm; that of the input, within ±512 mm
  Place proxy{};                ///< mm
  std::array<double, 3> force;  ///< N
  double penetration = 0;       ///< mm from proxy to HIP in contact, else 0
  double energy = 0;            ///< mJ that the hand has got since the field was loaded
  std::uint32_t status = 0;     ///< StatusBits
};

class Session {
 public:
  /// Without a field, with the standard settings, device and period.
  Session() = default;

  /// Takes a field as the controller does: its image and its certificate are checked completely. How stiff it may be is not judged, because no device
  /// renders it.
  ///
  /// image     8-byte aligned; stays alive and unchanged until the next `load` or `unload`
  /// returns   refused as FieldView::parse, kBadCertificate, kTooSteep
  Refused load(std::span<const std::uint8_t> image);
  /// Forgets the field: its bytes may go.
  void unload();
  /// The field; nothing before `load`.
  const std::optional<FieldView>& field() const { return field_; }

  /// How it feels: a row of kTickSettingRows, in its unit.
  ///
  /// returns   refused when there is no such row, or the value is outside its range or no number; 0 unsets what may be unset
  Refused set(std::size_t row, double value);
  double setting(std::size_t row) const;
  /// Of a hand without a device only the play of its counts is felt. The model stands in the trace, whose packets `isotouch trace to-packets` makes of it.
  ///
  /// returns   refused as decode_model
  Refused set_device(const DeviceModelBytes& bytes);
  const DeviceModel& device() const { return header_.device; }
  /// returns   refused outside the range of rows::kPeriod
  Refused set_period(double ns);
  std::uint32_t period_ns() const { return header_.period_ns; }

  /// Begins a trace in this memory; it ends when the memory is full. The core begins anew, which a hand in contact must not notice: so the trace begins with
  /// the next tick whose hand touches nothing. A new field, setting, device or period ends the trace; the next one begins in the same way. An empty room
  /// ends it, too.
  void record_into(std::span<std::uint8_t> room);
  /// The same trace goes on in more memory, which begins at the same address.
  void extend_room(std::span<std::uint8_t> room) { room_ = room; }
  /// Ticks in the trace.
  std::uint64_t recorded() const { return header_.record_count; }
  /// Does a trace wait until the hand touches nothing?
  bool waits() const { return !room_.empty() && begins_anew_; }
  /// Does the next tick need more memory than there is? Without more, the trace ends.
  bool is_full() const;
  /// The whole trace so far, its header finished; recording goes on behind it. Empty without a tick.
  std::span<const std::uint8_t> trace();

  /// One tick.
  ///
  /// hand      beyond ±512 mm the nearest place there, with kInputClamped
  /// buttons   bits 0 to 3; they are recorded
  /// returns   refused without a field, and for a coordinate that is no number
  Refused tick(const Place& hand, std::uint8_t buttons, Felt& felt);
  /// The hand leaves: wherever it comes back, nothing was done on its way.
  void lift() { work_.lift(); }

  /// The field's distance at a place, negative inside; beyond the band, and outside the grid, it is no more than the band.
  ///
  /// returns   refused as `tick`
  Refused sample(const Place& place, double& mm) const;

 private:
  void change();
  bool is_free_at(const Vec3<Mm>& hip) const;
  void begin();
  void keep(const Input& in, const Output& out);

  std::optional<FieldView> field_;
  TraceHeader header_ = standard_header();
  core::PositionModel model_;
  core::PositionState state_;
  HandWork work_;
  bool touched_ = false;  ///< in the last tick the hand touched, was inside or was being followed
  bool begins_anew_ = true;
  bool ended_ = false;  ///< the room was full: a tick is missing, so none may follow
  std::span<std::uint8_t> room_;
  std::optional<Chain> chain_;

  static TraceHeader standard_header();
};

}  // namespace isotouch::touch
