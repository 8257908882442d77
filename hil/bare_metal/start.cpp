/// What happens before main on a Cortex-M7: the vector table, memory as the language expects it, the floating-point unit that compilers move words with.
///
/// source    Armv7-M Architecture Reference Manual, B1.5 (reset), B3.2.20 (CPACR)
#include <cstddef>
#include <cstdint>

#include "hil/bare_metal/semihosting.h"

int main();

extern "C" {
// Places that board.ld names.
extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[], stack_top[];
extern const std::uint32_t data_image[];

[[noreturn]] void reset() {
  auto* const access = reinterpret_cast<volatile std::uint32_t*>(0xE000ED88);  // CPACR
  *access = *access | (0xFU << 20);
  asm volatile("dsb\n isb" ::: "memory");
  const std::uint32_t* from = data_image;
  for (std::uint32_t* to = data_begin; to != data_end;) *to++ = *from++;
  for (std::uint32_t* to = bss_begin; to != bss_end;) *to++ = 0;
  isotouch::semihosting::end(main());
}

[[noreturn]] void fault() {
  isotouch::semihosting::write("the processor met a fault\n");
  isotouch::semihosting::end(1);
}
}

namespace {

using Handler = void (*)();

/// The stack and the handlers of reset and of the 14 exceptions after it; no interrupt is ever enabled.
struct Vectors {
  std::uint32_t* stack = stack_top;
  Handler handlers[15] = {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault};
};

[[gnu::section(".vectors"), gnu::used]] constexpr Vectors kVectors;

}  // namespace
