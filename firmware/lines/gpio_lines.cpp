#include "firmware/lines/gpio_lines.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace isotouch::lines {

Refusal GpioLines::take(const GpioSettings& settings) {
  struct Wanted {
    const char* name;
    int offset;
    bool input;
    Line& line;
  };
  const Wanted all[] = {{"stop", settings.stop, true, stop_},
                        {"enable", settings.enable, false, enable_},
                        {"enable_back", settings.enable_back, true, enable_back_},
                        {"heartbeat", settings.heartbeat, false, heartbeat_},
                        {"light", settings.light, false, light_}};
  for (const Wanted& wanted : all) {
    if (wanted.offset < 0) continue;
    const auto offset = static_cast<unsigned>(wanted.offset);
    wanted.line = wanted.input ? chip_.input(offset, &wanted.line == &stop_) : chip_.output(offset);
    if (wanted.line == nullptr) {
      return std::string("lines.") + wanted.name + " = " + std::to_string(wanted.offset) +
             ": the line cannot be taken: " + std::strerror(errno) + "; name one that is free";
    }
  }
  return {};
}

void GpioLines::wait(std::int64_t until_ns) {
  const std::int64_t left = std::max(until_ns - clock_.now_ns(), std::int64_t{0});
  if (stop_ == nullptr || !stop_->wait_edge(left, edge_ns_)) clock_.sleep_until_ns(until_ns);
}

loop::LineInputs GpioLines::read() {
  loop::LineInputs in;
  in.stop = stop_ != nullptr && stop_->get() != 1;
  const int back = enable_failed_ ? -1 : enable_back_ != nullptr ? enable_back_->get() : set_.enable ? 1 : 0;
  in.enabled = back < 0 ? !set_.enable : back == 1;  // one that cannot be set or read is wrong, whatever it should be
  in.stop_edge_ns = edge_ns_;
  return in;
}

void GpioLines::set(const loop::LineOutputs& outputs) {
  set_ = outputs;
  enable_failed_ = enable_ != nullptr && !enable_->set(outputs.enable);
  if (heartbeat_ != nullptr) heartbeat_->set(outputs.heartbeat);
  if (light_ != nullptr) light_->set(outputs.light);
}

}  // namespace isotouch::lines
