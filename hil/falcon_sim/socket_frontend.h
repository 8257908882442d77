/// The local socket: one client at a time, one answer to each request in their order.
#pragma once

#include "hil/falcon_sim/frontend.h"
#include "hil/falcon_sim/listener.h"
#include "hil/falcon_sim/messages.h"

namespace isotouch::falcon_sim {

class SocketFrontend final : public Frontend {
 public:
  /// fails     std::runtime_error as Listener
  SocketFrontend(const std::filesystem::path& path, PacedDevice& device);

  void wait_for(std::vector<pollfd>& wanted) const override;
  std::optional<Time> due() const override;
  void serve(Time now) override;

 private:
  struct Pending {
    ReadRequest request;
    Time asked;
  };
  Time deadline(const Pending& pending) const;
  void welcome();
  void finish_read(Time now);
  bool serve_one(Time now);
  void send(const Bytes& answer);

  Listener listener_;
  PacedDevice& device_;
  Descriptor client_;
  std::optional<Pending> pending_;
  Bytes buffer_;
};

}  // namespace isotouch::falcon_sim
