// SPDX-License-Identifier: GPL-2.0
// The kernel's simulated interrupts as a module: Debian's kernel is built without them, and its simulated GPIO lines need them.
#include <linux/irq.h>
#include <linux/module.h>

#include "irq_sim.c"

MODULE_LICENSE("GPL");
MODULE_DESCRIPTION("simulated interrupts, from the kernel's own source");
