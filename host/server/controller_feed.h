/// A running controller, followed for the page: its ticks in batches, what it does in words, and its measures. A controller that goes away is waited for.
///
/// The controller sends ticks as to `isotouch watch`: it never waits for a client, and a client that reads too slowly loses ticks.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "host/link/controller.h"
#include "host/server/outbox.h"

namespace isotouch::server {

class ControllerFeed {
 public:
  using Send = std::function<void(Shared)>;
  /// What `isotouch status --json` prints.
  using Describe = std::function<nlohmann::ordered_json(link::Controller&)>;

  /// address   of the controller
  /// send      called by threads of this object
  ControllerFeed(std::string address, Send send, Describe describe);

  /// What a viewer that comes now has missed: the newest of each topic but ticks.
  std::vector<Shared> newest() const;

 private:
  void follow(const std::stop_token& stop);
  void follow_once(const std::stop_token& stop);
  void measure(const std::stop_token& stop);
  void tell(Topic topic, const nlohmann::ordered_json& json);
  /// False at once when this ends.
  static bool wait(const std::stop_token& stop, int ms);

  std::string address_;
  Send send_;
  Describe describe_;
  mutable std::mutex lock_;
  std::array<Shared, kTopics> newest_;
  bool was_there_ = false;
  std::jthread measures_, follows_;
};

}  // namespace isotouch::server
