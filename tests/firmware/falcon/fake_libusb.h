/// libusb without USB: its functions, as far as `firmware/falcon` calls them, in front of scripted Falcons. Programs that link it never see a real bus.
#pragma once

#include <vector>

#include "tests/firmware/falcon/fake_falcon.h"

namespace isotouch::test {

/// One device on the fake bus.
struct FakeUsbDevice {
  FakeFalcon* falcon = nullptr;  ///< its `faults.present` says whether it is plugged in
  std::string serial = "FAKE0001";
  std::uint16_t product = 0xCB48;
  int packet_size = 64;
  int open_error = 0, claim_error = 0;  ///< negative: refused
};

/// The bus. Empty it at the start of every test.
struct FakeBus {
  std::vector<FakeUsbDevice> devices;
  FakeClock* clock = nullptr;
  int init_error = 0;

  // What was seen.
  int contexts = 0, handles = 0, claimed = 0, transfers = 0, lists = 0;  ///< alive now
  int least_pending_in = 0;                                              ///< over all waits for events while open
  int cancelled = 0;
  int detaches = 0;
  int clear_halts = 0;

  // What goes wrong.
  int stall_in = 0, stall_out = 0, line_errors = 0;  ///< so many transfers end that way
};

FakeBus& fake_bus();

}  // namespace isotouch::test
