#include "firmware/falcon/falcon_session.h"

#include <algorithm>
#include <utility>

namespace isotouch::falcon {

FalconSession::FalconSession(FalconLink& link, loop::Clock& clock, std::span<const std::uint8_t> image, const SessionSettings& settings,
                             BootWatch watch)
    : link_(link),
      clock_(clock),
      image_(image),
      settings_(settings),
      watch_(std::move(watch)),
      device_(link, clock, settings.device),
      look_at_ns_(clock.now_ns()) {}

FalconSession::~FalconSession() { stop(); }

Exchange FalconSession::step(const FalconCommand& command) {
  Exchange result;
  result.lost = true;
  if (link_.is_open() && state_ != SessionState::kBooting && state_ != SessionState::kRunning) {  // a bit of the state has flipped
    device_.rest();
    search_again(0);
  }
  switch (state_) {
    case SessionState::kSearching: search(); break;
    case SessionState::kBooting: bring_up(); break;
    case SessionState::kRunning:
      result = device_.exchange(command);
      if (!result.lost) break;
      ++losses_;
      trouble_ = LinkError::kGone;
      device_.rest();
      search_again(settings_.search_ns);
      break;
  }
  return result;
}

void FalconSession::stop() {
  if (state_ == SessionState::kRunning) device_.rest();
  search_again(0);
}

void FalconSession::search() {
  const std::int64_t now = clock_.now_ns();
  if (now < look_at_ns_) {
    clock_.sleep_until_ns(std::min(look_at_ns_, now + settings_.nap_ns));
    return;
  }
  if (const LinkResult<void> opened = link_.open(); !opened) {
    trouble_ = opened.error();
    look_at_ns_ = now + settings_.search_ns;
    return;
  }
  trouble_.reset();
  state_ = SessionState::kBooting;
}

void FalconSession::bring_up() {
  last_boot_ = boot(link_, clock_, image_, settings_.boot, watch_);
  if (!last_boot_.running()) return search_again(settings_.retry_ns);
  device_.begin();
  state_ = SessionState::kRunning;
}

void FalconSession::search_again(std::int64_t after_ns) {
  link_.close();
  state_ = SessionState::kSearching;
  look_at_ns_ = clock_.now_ns() + after_ns;
}

}  // namespace isotouch::falcon
