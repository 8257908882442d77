/// The way of a reply from the board to the chip, with what may happen to it there.
#pragma once

#include <deque>

#include "hil/falcon_model/faults.h"
#include "hil/falcon_model/ft232r.h"
#include "hil/falcon_model/packets.h"

namespace isotouch::falcon_model {

class ReplyWire {
 public:
  /// The next reply suffers this; kinds that are not a reply's are ignored.
  void order(const Fault& fault);
  /// What the next reply suffers.
  const std::deque<Fault>& orders() const { return orders_; }

  /// Sends one reply, or nothing, or those that waited.
  void send(const PacketBytes& reply, Ft232r& chip);

  /// Forgets what is on its way.
  void clear();

 private:
  std::deque<Fault> orders_;
  PacketBytes last_{};
  Bytes held_;
  int hold_ = 0;  ///< packets until what is held goes
};

}  // namespace isotouch::falcon_model
