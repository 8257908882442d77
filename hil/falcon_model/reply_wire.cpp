#include "hil/falcon_model/reply_wire.h"

#include <algorithm>
#include <utility>

namespace isotouch::falcon_model {

void ReplyWire::order(const Fault& fault) { orders_.push_back(fault); }

void ReplyWire::clear() {
  orders_.clear();
  held_.clear();
  hold_ = 0;
}

void ReplyWire::send(const PacketBytes& reply, Ft232r& chip) {
  Bytes bytes(reply.begin(), reply.end());
  const PacketBytes before = std::exchange(last_, reply);
  std::size_t split = 0;
  bool splits = false;
  if (hold_ > 0) --hold_;
  for (; !orders_.empty(); orders_.pop_front()) {
    const Fault& fault = orders_.front();
    const auto first = static_cast<std::size_t>(fault.arguments[0]);
    switch (fault.kind) {
      case FaultKind::kShort: bytes.resize(14); break;
      case FaultKind::kMerged: hold_ = std::max(hold_, 1); break;
      case FaultKind::kLate: hold_ = std::max(hold_, fault.arguments[0]); break;
      case FaultKind::kCorrupt:
        if (first < bytes.size()) bytes[first] ^= static_cast<std::uint8_t>(fault.arguments[1]);
        break;
      case FaultKind::kRepeated: bytes.assign(before.begin(), before.end()); break;
      case FaultKind::kSplit:
        splits = true;
        split = std::min(first, bytes.size());
        break;
      case FaultKind::kModemOnly: chip.withhold(fault.arguments[0]); break;
      default: break;
    }
  }
  if (hold_ > 0) {
    held_.insert(held_.end(), bytes.begin(), bytes.end());
    return;
  }
  chip.receive(std::exchange(held_, {}));
  if (splits) {
    chip.receive({bytes.data(), split});
    chip.split();
    bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(split));
  }
  chip.receive(bytes);
}

}  // namespace isotouch::falcon_model
