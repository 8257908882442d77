#include "host/server/tick_rows.h"

#include <limits>

#include "host/server/put_bytes.h"
#include "host/to_double.h"

namespace isotouch::server {

namespace {

/// shared/SPEC.md: a device's tick says zeros while nobody knows where the hand is.
bool is_hip_known(const TraceRecord& record) { return record.input.kind != InputKind::kPacket || record.output.hip != Vec3<Mm>{}; }

}  // namespace

nlohmann::ordered_json column_names() { return {{"floats", kFloatColumns}, {"wholes", kWholeColumns}, {"row_bytes", kRowBytes}}; }

void RowWriter::append(const TraceRecord& record, std::string& rows) {
  const Output& out = record.output;
  Eigen::Vector3d hip = to_double(out.hip), proxy = to_double(out.proxy);
  const Eigen::Vector3d force = to_double(out.force);
  if (is_hip_known(record)) {
    work_.add({hip.x(), hip.y(), hip.z()}, {force.x(), force.y(), force.z()}, may_give_force(record.input.kind, out));
  } else {
    work_.lift();
    hip = proxy = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  for (const Eigen::Vector3d& vector : {hip, proxy, force}) {
    for (const double value : vector) put_float(rows, value);
  }
  put_float(rows, (out.status & kContact) != 0 ? (proxy - hip).norm() : 0);
  put_float(rows, work_.mj());
  put_whole(rows, out.status);
  put_whole(rows, std::uint32_t{out.state} | std::uint32_t{out.faults} << 16);
  put_whole(rows, record.input.field_generation);
}

}  // namespace isotouch::server
