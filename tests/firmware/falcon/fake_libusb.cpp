#include "tests/firmware/falcon/fake_libusb.h"

#include <libusb.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>
#include <string>
#include <utility>
#include <vector>

using isotouch::test::fake_bus;
using isotouch::test::FakeBus;
using isotouch::test::FakeUsbDevice;

// The types that libusb.h only names.
struct libusb_context {};
struct libusb_device {
  std::size_t index;
};
struct libusb_device_handle {
  std::size_t index;
  std::deque<libusb_transfer*> in, out;  ///< pending, oldest first
  std::vector<libusb_transfer*> ended;   ///< status set, callback due
};

namespace {

libusb_device_handle* the_handle = nullptr;  // one program, one handle at a time

FakeUsbDevice& device_of(std::size_t index) { return fake_bus().devices[index]; }

void end(std::deque<libusb_transfer*>& pending, libusb_transfer_status status, int length) {
  libusb_transfer* transfer = pending.front();
  pending.pop_front();
  transfer->status = status;
  transfer->actual_length = length;
  the_handle->ended.push_back(transfer);
}

bool is_due(int& count) { return count > 0 && count-- > 0; }

/// Hands what the Falcon has sent to the oldest IN transfer; false when it has nothing.
bool deliver(std::uint32_t timeout_ms) {
  if (the_handle->in.empty()) return false;
  if (is_due(fake_bus().stall_in)) return end(the_handle->in, LIBUSB_TRANSFER_STALL, 0), true;
  if (is_due(fake_bus().line_errors)) return end(the_handle->in, LIBUSB_TRANSFER_ERROR, 0), true;
  libusb_transfer* transfer = the_handle->in.front();
  const auto size = device_of(the_handle->index).falcon->read({transfer->buffer, static_cast<std::size_t>(transfer->length)}, timeout_ms);
  if (!size) return false;
  end(the_handle->in, LIBUSB_TRANSFER_COMPLETED, static_cast<int>(*size));
  return true;
}

void unplug_all() {
  while (!the_handle->in.empty()) end(the_handle->in, LIBUSB_TRANSFER_NO_DEVICE, 0);
  while (!the_handle->out.empty()) end(the_handle->out, LIBUSB_TRANSFER_NO_DEVICE, 0);
}

void send_out() {
  while (!the_handle->out.empty()) {
    libusb_transfer* transfer = the_handle->out.front();
    if (is_due(fake_bus().stall_out)) {
      end(the_handle->out, LIBUSB_TRANSFER_STALL, 0);
      continue;
    }
    const std::span<const std::uint8_t> data(transfer->buffer, static_cast<std::size_t>(transfer->length));
    for (std::size_t sent = 0; sent < data.size();) {
      const auto taken = device_of(the_handle->index).falcon->write(data.subspan(sent), 0);
      if (!taken) return unplug_all();
      sent += *taken;
    }
    end(the_handle->out, LIBUSB_TRANSFER_COMPLETED, transfer->length);
  }
}

void call_back() {
  const std::vector<libusb_transfer*> ended = std::exchange(the_handle->ended, {});
  for (libusb_transfer* transfer : ended) transfer->callback(transfer);
}

}  // namespace

namespace isotouch::test {
FakeBus& fake_bus() {
  static FakeBus bus;
  return bus;
}
}  // namespace isotouch::test

extern "C" {

int LIBUSB_CALL libusb_init(libusb_context** context) {
  if (fake_bus().init_error != 0) return fake_bus().init_error;
  *context = new libusb_context;
  ++fake_bus().contexts;
  return 0;
}

void LIBUSB_CALL libusb_exit(libusb_context* context) {
  --fake_bus().contexts;
  delete context;
}

ssize_t LIBUSB_CALL libusb_get_device_list(libusb_context* /*context*/, libusb_device*** list) {
  ++fake_bus().lists;
  const std::size_t most = fake_bus().devices.size();
  *list = new libusb_device*[most + 1];
  std::size_t count = 0;
  for (std::size_t i = 0; i < most; ++i) {
    if (device_of(i).falcon->faults.present) (*list)[count++] = new libusb_device{i};
  }
  (*list)[count] = nullptr;
  return static_cast<ssize_t>(count);
}

void LIBUSB_CALL libusb_free_device_list(libusb_device** list, int /*unref*/) {
  --fake_bus().lists;
  for (libusb_device** device = list; *device != nullptr; ++device) delete *device;
  delete[] list;
}

int LIBUSB_CALL libusb_get_device_descriptor(libusb_device* device, libusb_device_descriptor* descriptor) {
  *descriptor = {18, 1, 0x0200, 0, 0, 0, 8, 0x0403, device_of(device->index).product, 0x0600, 1, 2, 3, 1};
  return 0;
}

std::uint8_t LIBUSB_CALL libusb_get_bus_number(libusb_device* /*device*/) { return 1; }
std::uint8_t LIBUSB_CALL libusb_get_device_address(libusb_device* device) { return static_cast<std::uint8_t>(device->index + 2); }
int LIBUSB_CALL libusb_get_max_packet_size(libusb_device* device, unsigned char /*endpoint*/) {
  return device_of(device->index).packet_size;
}

int LIBUSB_CALL libusb_open(libusb_device* device, libusb_device_handle** handle) {
  FakeUsbDevice& fake = device_of(device->index);
  if (fake.open_error != 0) return fake.open_error;
  if (!fake.falcon->open()) return LIBUSB_ERROR_NO_DEVICE;
  *handle = the_handle = new libusb_device_handle{device->index, {}, {}, {}};
  ++fake_bus().handles;
  return 0;
}

void LIBUSB_CALL libusb_close(libusb_device_handle* handle) {
  device_of(handle->index).falcon->close();
  --fake_bus().handles;
  delete handle;
  the_handle = nullptr;
}

int LIBUSB_CALL libusb_get_string_descriptor_ascii(libusb_device_handle* handle, std::uint8_t index, unsigned char* data, int length) {
  const std::array<std::string, 3> texts = {"maker", "FALCON HAPTIC", device_of(handle->index).serial};
  const std::string& text = texts[index - 1U];
  const std::size_t size = std::min(text.size(), static_cast<std::size_t>(length));
  std::memcpy(data, text.data(), size);
  return static_cast<int>(size);
}

int LIBUSB_CALL libusb_set_auto_detach_kernel_driver(libusb_device_handle* /*handle*/, int enable) {
  fake_bus().detaches += enable;
  return 0;
}

int LIBUSB_CALL libusb_claim_interface(libusb_device_handle* handle, int /*number*/) {
  const int error = device_of(handle->index).claim_error;
  fake_bus().claimed += error == 0 ? 1 : 0;
  return error;
}

int LIBUSB_CALL libusb_release_interface(libusb_device_handle* /*handle*/, int /*number*/) {
  --fake_bus().claimed;
  return 0;
}

int LIBUSB_CALL libusb_control_transfer(libusb_device_handle* handle, std::uint8_t type, std::uint8_t request, std::uint16_t value,
                                        std::uint16_t index, unsigned char* data, std::uint16_t length, unsigned /*timeout*/) {
  const auto low = [](int number) { return static_cast<std::uint8_t>(number & 0xFF); };
  const auto high = [](int number) { return static_cast<std::uint8_t>(number >> 8); };
  const auto done = device_of(handle->index)
                        .falcon->control({type, request, low(value), high(value), low(index), high(index), low(length), high(length)},
                                         {data, static_cast<std::size_t>(length)});
  if (done) return static_cast<int>(*done);
  return done.error() == isotouch::falcon::LinkError::kStalled ? LIBUSB_ERROR_PIPE : LIBUSB_ERROR_NO_DEVICE;
}

int LIBUSB_CALL libusb_clear_halt(libusb_device_handle* /*handle*/, unsigned char /*endpoint*/) {
  ++fake_bus().clear_halts;
  return 0;
}

libusb_transfer* LIBUSB_CALL libusb_alloc_transfer(int /*packets*/) {
  ++fake_bus().transfers;
  return new libusb_transfer{};
}

void LIBUSB_CALL libusb_free_transfer(libusb_transfer* transfer) {
  if (transfer == nullptr) return;
  --fake_bus().transfers;
  delete transfer;
}

int LIBUSB_CALL libusb_submit_transfer(libusb_transfer* transfer) {
  if (!device_of(the_handle->index).falcon->faults.present) return LIBUSB_ERROR_NO_DEVICE;
  (transfer->endpoint == 0x81 ? the_handle->in : the_handle->out).push_back(transfer);
  return 0;
}

int LIBUSB_CALL libusb_cancel_transfer(libusb_transfer* transfer) {
  for (std::deque<libusb_transfer*>* pending : {&the_handle->in, &the_handle->out}) {
    const auto at = std::find(pending->begin(), pending->end(), transfer);
    if (at == pending->end()) continue;
    pending->erase(at);
    transfer->status = LIBUSB_TRANSFER_CANCELLED;
    the_handle->ended.push_back(transfer);
    ++fake_bus().cancelled;
    return 0;
  }
  return LIBUSB_ERROR_NOT_FOUND;
}

int LIBUSB_CALL libusb_handle_events_timeout_completed(libusb_context* /*context*/, timeval* wait, int* /*completed*/) {
  FakeBus& bus = fake_bus();
  bus.least_pending_in = std::min(bus.least_pending_in, static_cast<int>(the_handle->in.size()));
  if (!device_of(the_handle->index).falcon->faults.present) unplug_all();
  send_out();
  while (deliver(0)) {
  }
  const std::int64_t until = bus.clock->now + (wait->tv_sec * std::int64_t{1'000'000} + wait->tv_usec) * 1000;
  while (the_handle->ended.empty() && bus.clock->now < until) {
    if (!deliver(1)) bus.clock->now = std::min(until, bus.clock->now + 1'000'000);
  }
  call_back();
  return 0;
}

}  // extern "C"
