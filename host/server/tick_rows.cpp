#include "host/server/tick_rows.h"

#include "host/server/put_bytes.h"
#include "host/to_double.h"

namespace isotouch::server {

nlohmann::ordered_json column_names() { return {{"floats", kFloatColumns}, {"wholes", kWholeColumns}, {"row_bytes", kRowBytes}}; }

void RowWriter::append(const TraceRecord& record, std::string& rows) {
  const Output& out = record.output;
  const Eigen::Vector3d hip = to_double(out.hip), proxy = to_double(out.proxy), force = to_double(out.force);
  if (began_ && may_give_force(record.input.kind, out)) energy_mj_ += force.dot(hip - Eigen::Vector3d(hip_[0], hip_[1], hip_[2]));
  began_ = true;
  hip_ = {hip.x(), hip.y(), hip.z()};
  for (const Eigen::Vector3d& vector : {hip, proxy, force}) {
    for (const double value : vector) put_float(rows, value);
  }
  put_float(rows, (out.status & kContact) != 0 ? (proxy - hip).norm() : 0);
  put_float(rows, energy_mj_);
  put_whole(rows, out.status);
  put_whole(rows, std::uint32_t{out.state} | std::uint32_t{out.faults} << 16);
  put_whole(rows, record.input.field_generation);
}

}  // namespace isotouch::server
