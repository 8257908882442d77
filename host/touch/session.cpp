#include "host/touch/session.h"

#include <algorithm>

#include "firmware/core/field_sampler.h"
#include "firmware/core/index_frame.h"
#include "shared/certificate.h"

namespace isotouch::touch {

namespace {

using trace_layout::kHeaderBytes, trace_layout::kRecordBytes;

constexpr Refused kNoField = "there is no field; load one first";
constexpr Refused kNoNumber = "a coordinate is not a number";

bool is_number(double value) { return value - value == 0; }  // neither NaN nor infinite

template <class Q>
double to_double(Q quantity) {
  return static_cast<double>(quantity.raw()) / static_cast<double>(std::int64_t{1} << Q::kFractionBits);
}

Place to_doubles(const Vec3<Mm>& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }

/// The nearest coordinate, ties up; beyond ±2047 mm the nearest there, which the core clamps further.
Mm to_mm(double value) {
  const double scaled = std::clamp(value, -2047.0, 2047.0) * static_cast<double>(1 << Mm::kFractionBits) + 0.5;
  auto raw = static_cast<std::int32_t>(scaled);
  if (static_cast<double>(raw) > scaled) --raw;  // rounded down, as floor does
  return Mm::from_raw(raw);
}

std::optional<Vec3<Mm>> to_mm(const Place& place) {
  if (!is_number(place[0]) || !is_number(place[1]) || !is_number(place[2])) return std::nullopt;
  return Vec3<Mm>{to_mm(place[0]), to_mm(place[1]), to_mm(place[2])};
}

double length(const Vec3<Mm>& v) {
  const Place d = to_doubles(v);
  return __builtin_sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

/// Is a value one that the row takes? Compared before it becomes an integer, which may not hold it.
bool holds(const SettingRow& row, double value) { return (value >= row.low && value <= row.high) || (row.zero_means_unset && value == 0); }

}  // namespace

TraceHeader Session::standard_header() {
  TraceHeader header;
  header.has_outputs = true;
  return header;
}

Refused Session::load(std::span<const std::uint8_t> image) {
  const Result<FieldView> view = FieldView::parse(image);
  if (!view) return describe(view.error());
  const CertificateCheck check = check_certificate(*view, assumed_loop(*view), {});
  if (!check.accepted && check.error != Error::kTooStiff) return describe(check.error);
  field_ = *view;
  header_.field_hash = view->hash();
  state_ = {};  // nothing that was felt before holds
  touched_ = false;
  work_ = {};
  change();
  return nullptr;
}

void Session::unload() {
  field_.reset();
  header_.field_hash = 0;
  change();
}

Refused Session::set(std::size_t row, double value) {
  if (row >= kTickSettings) return "there is no setting of this number";
  if (!holds(*kTickSettingRows[row], value)) return "the value is outside the setting's range";
  RawSettings raw = raw_settings(header_.settings);
  raw[row] = kTickSettingRows[row]->raw(value);
  header_.settings = from_raw(raw);
  change();
  return nullptr;
}

double Session::setting(std::size_t row) const {
  return row < kTickSettings ? kTickSettingRows[row]->value(raw_settings(header_.settings)[row]) : 0;
}

Refused Session::set_device(const DeviceModelBytes& bytes) {
  const Result<DeviceModel> device = decode_model(bytes);
  if (!device) return describe(device.error());
  header_.device = *device;
  change();
  return nullptr;
}

Refused Session::set_period(double ns) {
  if (!holds(rows::kPeriod, ns)) return "the period is outside its range";
  header_.period_ns = static_cast<std::uint32_t>(rows::kPeriod.raw(ns));
  change();
  return nullptr;
}

/// What the core is prepared with is another: it is felt from the next tick on, and the trace begins anew.
void Session::change() {
  header_.record_count = 0;
  begins_anew_ = true;
  if (field_) model_ = core::make_position_model(header_.device, header_.settings, header_.period_ns, *field_);
}

void Session::record_into(std::span<std::uint8_t> room) {
  room_ = room;
  header_.record_count = 0;
  begins_anew_ = true;
}

bool Session::is_full() const { return room_.size() < kHeaderBytes + (header_.record_count + 1) * kRecordBytes; }

std::span<const std::uint8_t> Session::trace() {
  if (header_.record_count == 0) return {};
  const TraceHeaderBytes bytes = encode(header_);
  std::copy(bytes.begin(), bytes.end(), room_.begin());
  return room_.first(kHeaderBytes + static_cast<std::size_t>(header_.record_count) * kRecordBytes);
}

/// No force changes when the core forgets what was before: the hand touches nothing, and did not.
bool Session::is_free_at(const Vec3<Mm>& hip) const {
  return !touched_ && core::sample_field(*field_, core::to_index(within(hip, core::kReach), *field_)).distance > Voxel{};
}

void Session::begin() {
  state_ = {};
  chain_.emplace(header_);
  begins_anew_ = false;
  ended_ = false;
}

void Session::keep(const Input& in, const Output& out) {
  ended_ = ended_ || is_full();
  if (begins_anew_ || ended_) return;
  TraceRecord record{in, out, chain_->extend(in, out), header_.record_count * header_.period_ns};
  const TraceRecordBytes bytes = encode(record);
  std::copy(bytes.begin(), bytes.end(), room_.begin() + static_cast<std::ptrdiff_t>(kHeaderBytes + header_.record_count * kRecordBytes));
  ++header_.record_count;
}

Refused Session::tick(const Place& hand, std::uint8_t buttons, Felt& felt) {
  if (!field_) return kNoField;
  const std::optional<Vec3<Mm>> hip = to_mm(hand);
  if (!hip) return kNoNumber;
  Input in = position_input(*hip);
  in.buttons = buttons & 0xF;
  if (begins_anew_ && is_free_at(*hip)) begin();
  const Output out = core::render_position(in, *field_, model_, state_);
  keep(in, out);
  touched_ = (out.status & (kContact | kFollowing | kHeldInside)) != 0;
  felt.hip = to_doubles(out.hip);
  felt.proxy = to_doubles(out.proxy);
  felt.force = {to_double(out.force.x), to_double(out.force.y), to_double(out.force.z)};
  felt.penetration = (out.status & kContact) != 0 ? length(out.proxy - out.hip) : 0;
  work_.add(felt.hip, felt.force);
  felt.energy = work_.mj();
  felt.status = out.status;
  return nullptr;
}

Refused Session::sample(const Place& place, double& mm) const {
  if (!field_) return kNoField;
  const std::optional<Vec3<Mm>> at = to_mm(place);
  if (!at) return kNoNumber;
  const Voxel distance = core::sample_field(*field_, core::to_index(*at, *field_)).distance;
  mm = to_double(distance) * to_double(field_->edge);
  return nullptr;
}

}  // namespace isotouch::touch
