/// Ends the virtual machine it runs in, with a code that becomes QEMU's exit code. Where nobody listens, as on a real board, it waits until the power is
/// switched off. Usage: end_machine CODE.
///
/// source    "Semihosting for AArch32 and AArch64", SYS_EXIT_EXTENDED (0x20): a reason and a code; QEMU needs `-semihosting-config userspace=on`
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace {

/// A real board's answer to the instruction below.
[[noreturn]] void wait_for_power_off(int) {
  for (;;) pause();
}

}  // namespace

#if defined(__arm__)
__attribute__((target("arm")))  // its number does not fit into a Thumb instruction
#endif
int main(int argc, char** argv) {
  std::signal(SIGILL, wait_for_power_off);
  constexpr unsigned long kApplicationExit = 0x20026;
  const unsigned long block[2] = {kApplicationExit, argc == 2 ? std::strtoul(argv[1], nullptr, 10) : 255};
#if defined(__aarch64__)
  register unsigned long operation asm("x0") = 0x20;
  register const unsigned long* argument asm("x1") = block;
  asm volatile("hlt #0xf000" : "+r"(operation) : "r"(argument) : "memory");
#else
  register unsigned long operation asm("r0") = 0x20;
  register const unsigned long* argument asm("r1") = block;
  register unsigned long number asm("r7") = 0xffff'ffff;  // a real board's kernel takes it for a system call: for none
  asm volatile("svc #0x123456" : "+r"(operation) : "r"(argument), "r"(number) : "memory");
#endif
  wait_for_power_off(0);
}
