/// The work of a stream: frames → a growing field → a controller, which gets the field once, then a patch for each frame that changes it, and patches for
/// the points that wait when no frame comes.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "host/cloud/source_file.h"
#include "host/encoding/write_image.h"
#include "host/link/controller.h"
#include "host/live/space.h"
#include "host/stream/classes.h"
#include "host/stream/growing_field.h"
#include "host/stream/inbox.h"

namespace isotouch::stream {

struct StreamOptions {
  std::string to;                               ///< address of the controller; empty: the field only grows here
  std::string name = "stream";                  ///< of the field, as the controller lists it
  std::optional<Eigen::AlignedBox3d> box = {};  ///< input coordinates; not given: by the first frame
  live::SpaceOptions space;
  encoding::FieldInfo info = {};
  std::optional<Eigen::Vector3d> viewpoint = {};        ///< every normal is turned towards it
  std::optional<Clock::duration> keep = {};             ///< how long a point counts
  std::uint32_t enough = 0;                             ///< so many points of a bucket count; 0: all
  std::function<void(const FieldView&)> on_first = {};  ///< called before the first field is sent
  /// How long a patch that the controller refuses is sent again, as long as nobody replaced the field: another client may send one that is refused in turn,
  /// or have the arms measured.
  Clock::duration patience = std::chrono::seconds(60);
};

/// Counts since some time.
struct Tally {
  std::uint64_t frames = 0;      ///< taken
  std::uint64_t empty = 0;       ///< of them without a point
  std::uint64_t unoriented = 0;  ///< of them with points, and without normals
  PointCounts points;
  std::uint64_t patches = 0, patch_bytes = 0;
  Classes delay_ms{10};     ///< from the arrival of a frame until the controller has confirmed its patch
  double refused_s = 0;     ///< in which the controller refused a patch that was sent again
  std::string refusal;      ///< the last of these
  bool unanswered = false;  ///< the controller was waited for when that time ended
};

/// Of a whole stream.
struct StreamReport {
  Tally all;
  std::uint64_t offered = 0, thinned = 0;  ///< frames
  std::uint64_t heard = 0;                 ///< ticks of a hand
  std::uint64_t lost = 0;                  ///< ticks of another controller that did not arrive, or whose touches had no room
  std::uint64_t upload_bytes = 0;          ///< of the first field, packed
  Classes read_ms{10}, grow_ms{10}, patch_ms{10}, controller_ms{10};  ///< the parts of the delay, behind the wait for the frame before
  Classes patch_bytes{0.01};
  double seconds = 0;
  bool had_stiffness = false;  ///< points of it, which a live field leaves out
};

class Stream {
 public:
  explicit Stream(StreamOptions options);
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// What the controller gets for each field, patch or question once the stream is over.
  static constexpr std::chrono::seconds kGrace{2};

  /// What the stream asks and reports. All of it lives until after `finish`.
  struct Watch {
    std::function<bool()> is_over;             ///< asked ten times a second and oftener
    std::function<void(const Tally&)> second;  ///< called each second with what it brought
  };
  /// Connects to the controller, if one was named; once, before `run`.
  ///
  /// fails     InputError: as link::Controller, also when the stream is over meanwhile
  void connect(Watch watch);
  bool is_connected() const { return status_.has_value(); }
  /// Works until there are no more frames.
  ///
  /// fails     InputError: what the source fails with, a frame that cannot be read, a controller that refuses; LinkError: one that is gone.
  ///           What the field held before it still holds. Behind an error of the source it is finished, as far as the controller lets it: see `is_felt`
  void run(Inbox& inbox);
  /// Sends what has not been sent, if anything, and looks whether the controller has it.
  ///
  /// fails     InputError: as `run`
  void finish();

  /// Has the controller confirmed all that was taken, as far as is known? True where nothing was taken.
  bool is_felt() const;
  /// Was the stream over, and the controller silent or refusing until its time was up, too?
  bool has_given_up() const { return has_given_up_; }
  /// Did somebody load another field?
  bool is_replaced() const { return is_replaced_; }
  /// Has any point come into the field? It may have gone again.
  bool has_points() const { return report_.all.points.taken > 0; }
  /// Nothing before the first frame that shows where the field lies.
  const GrowingField* field() const { return field_ ? &*field_ : nullptr; }
  const live::Space& space() const { return *space_; }
  /// The field as it is now.
  const field_file::OpenField& whole() { return field_->keep_whole(); }
  const StreamReport& report() const { return report_; }
  /// In what fault the controller was when it was asked last, and the next step; empty: in none.
  const std::string& fault() const { return fault_; }

 private:
  void work_on(const Frame& frame);
  void work_idly();
  void count(const PointCounts& points);
  bool begin(const cloud::Model& model);
  void send();
  void upload();
  void patch();
  protocol::Accepted send_patch(std::span<const std::uint8_t> patch);
  void finish_after_error();
  bool is_due() const;
  bool gives_up();
  bool is_too_late(Clock::time_point asked);
  void report_second();
  bool is_still_own();
  void ask_status();
  void require_own_field();

  StreamOptions options_;
  std::optional<link::Controller> controller_;
  std::optional<protocol::StatusReport> status_;
  std::string fault_;
  std::optional<live::Space> space_;
  std::optional<GrowingField> field_;
  std::optional<std::uint64_t> felt_;  ///< hash of the field that the controller has from here
  bool is_replaced_ = false;           ///< somebody loaded another one
  bool has_failed_ = false;            ///< what is kept was not taken over
  bool has_given_up_ = false;
  StreamReport report_;
  Tally second_;
  Watch watch_;
  Clock::time_point reported_, asked_;     ///< a second; the controller
  std::optional<Clock::time_point> over_;  ///< since then, as far as was seen while the controller was waited for
};

}  // namespace isotouch::stream
