/// Counts the allocations of each thread, so that the tick's can be told to be none.
#include "firmware/loop/realtime.h"
#include "firmware/loop/replaced_malloc.h"

void isotouch::count_allocation() { ++loop::allocations_of_thread; }
