/// A running controller, followed for the page: its ticks in batches, what it does in words, its measures, and its field. A controller that goes away is
/// waited for.
///
/// The controller sends ticks as to `isotouch watch`: it never waits for a client, and a client that reads too slowly loses ticks.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
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

  /// What becomes of the field that the controller has.
  struct Field {
    std::function<bool(std::uint64_t hash)> wanted;  ///< false: it is known, or another object is to be seen
    /// May take its time. May throw InputError: its sentence stands beside the measures as long as the controller has this field. What else it throws
    /// is over in a moment, and the field comes again.
    std::function<void(const std::string& name, const link::Controller::Image&)> taken;
  };

  /// address   of the controller
  /// send, field   called by threads of this object; send must not call this object
  ControllerFeed(std::string address, Send send, Describe describe, Field field);

  /// What a viewer that comes now has missed: the newest of each topic but ticks.
  std::vector<Shared> newest() const;

 private:
  void follow(const std::stop_token& stop);
  void follow_once(const std::stop_token& stop);
  void measure(const std::stop_token& stop);
  void tell_measures(link::Controller& controller);
  void take_field(link::Controller& controller);
  void tell(Topic topic, const nlohmann::ordered_json& json);
  /// False at once when this ends.
  static bool wait(const std::stop_token& stop, int ms);

  std::string address_;
  Send send_;
  Describe describe_;
  Field field_;
  mutable std::mutex lock_;
  std::array<Shared, kTopics> newest_;
  bool is_there_ = false;       ///< as `follow`, which alone changes it, has told last
  std::uint64_t unusable_ = 0;  ///< the hash of a field that could not be taken; 0: none
  std::string why_unusable_;
  std::atomic<std::uint16_t> standing_{0};  ///< faults, those before a restart among them, which no tick has
  std::atomic<protocol::OtherAngles> others_{protocol::OtherAngles::kNone};
  std::jthread measures_, follows_;
};

}  // namespace isotouch::server
