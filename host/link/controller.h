/// A running controller, as the host tool speaks with it: each request of the protocol is one function.
///
/// fails     every function: InputError with the address and one sentence, the controller's own where it refuses; LinkError where it cannot be heard.
///           After an answer that did not come in time or did not fit, all further requests fail: connect anew
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/link/connection.h"
#include "shared/device_model.h"
#include "shared/protocol_messages.h"

namespace isotouch::link {

/// How many values were at most `upper`, and above the class before; ns.
struct Histogram {
  std::uint64_t count = 0;
  std::vector<protocol::Bin> bins;
};

class Controller {
 public:
  /// Connects and greets.
  ///
  /// longest_ms  to wait for any answer; without it each request has its own patience, from seconds to minutes
  /// is_over     asked ten times a second while the controller is waited for; true: nobody wants its answer any more, and the request fails
  explicit Controller(const std::string& address, std::optional<int> longest_ms = {}, std::function<bool()> is_over = {});

  const protocol::Welcome& welcome() const { return welcome_; }

  protocol::StatusReport status();

  struct Settings {
    std::uint64_t checksum = 0;
    std::vector<std::pair<std::string, std::string>> different;  ///< name and value of those that differ from their default
  };
  Settings settings();
  Histogram histogram(protocol::Measure measure);

  /// Sends a packed field. It is felt when this returns; when it throws the controller keeps the field before.
  ///
  /// packed    as `field` promises
  protocol::Accepted upload(const protocol::Begin& field, std::span<const std::uint8_t> packed);
  /// Sends a patch (SPEC.md, section 7) of the field that the controller uses. Returns once the tick feels it; whoever has more waits for that.
  ///
  /// fails     as every request: the controller refuses it where it uses another field
  protocol::Accepted patch(std::span<const std::uint8_t> patch);

  struct Image {
    std::uint64_t hash = 0;
    std::vector<std::uint8_t> bytes;  ///< as the controller has them in memory; not yet checked
  };
  /// The field that is felt, also one that patches change.
  ///
  /// fails     as every request: also while another client reads it. Connect anew then
  Image image();

  std::vector<protocol::FieldEntry> fields();
  protocol::Accepted select(std::uint64_t image_hash);
  protocol::DeviceReport device();
  /// Where the arms stand, measured over a second in which the hand must hold still.
  ///
  /// model     gets the device model in use
  protocol::PostureReport posture(DeviceModel& model);
  /// The controller keeps these angles.
  void calibrate(const protocol::Calibrate& measured);
  /// The ticks whose commands came latest since they were last forgotten.
  ///
  /// anew      those until now are forgotten after this
  std::vector<protocol::WorstTick> worst_ticks(bool anew);
  void stop();
  void resume();
  /// A setting that may change while it is felt, and its value as in the settings' file.
  ///
  /// fails     InputError: also where one of them has more than 63 bytes or is not printable; then nothing is sent
  void set(const std::string& name, const std::string& value);

  /// Records so many ticks from now.
  ///
  /// header    called once with the trace's header
  /// record    called with each record in turn, without a gap
  /// enough    asked ten times a second and oftener; true: what came until now is all that is wanted
  /// returns   why fewer came than were wanted: a refusal, a gap, a connection that was cut; empty: they all came, or were enough
  ///
  /// fails     also as above, as long as no record has come
  std::string record(std::uint64_t ticks, const std::function<void(std::span<const std::uint8_t>)>& header,
                     const std::function<void(std::span<const std::uint8_t>)>& record, const std::function<bool()>& enough);

  struct Watched {
    std::uint64_t lost = 0;  ///< records, meanwhile
    std::string ended;       ///< as `record` returns it
  };
  /// Follows the ticks. Whoever reads too slowly loses records, the controller no time.
  ///
  /// every     a record every so many ticks, at least 1
  /// records   so many
  /// record    called with the tick's number and each record in turn
  /// enough    as above
  /// paused    called where all that has come is taken, as after each burst
  ///
  /// fails     as `record`
  Watched watch(std::uint32_t every, std::uint64_t records, const std::function<void(std::uint64_t, std::span<const std::uint8_t>)>& record,
                const std::function<bool()>& enough, const std::function<void()>& paused = {});

 private:
  protocol::Accepted send_upload(std::span<const std::uint8_t> packed);
  protocol::Frame expect(protocol::Kind kind, int patience_ms);
  void pass_over(std::size_t answers);
  protocol::Frame required(protocol::Kind kind, const protocol::Frame& frame);
  std::optional<protocol::Records> more_records(std::uint64_t taken, int patience_ms, const std::function<bool()>& enough,
                                                std::string& ended);
  template <class Message>
  Message read(const protocol::Frame& frame);
  [[noreturn]] void complain(const std::string& sentence);

  int patient(int patience_ms) const { return std::min(patience_ms, longest_ms_); }

  int longest_ms_;
  std::function<bool()> is_over_;
  Connection connection_;
  protocol::Welcome welcome_;
};

}  // namespace isotouch::link
