/*
 * A plain 1 kHz loop: the position of a hand goes in, the force on it comes out.
 *
 *     loop FIELD TRACE [SECONDS]
 *
 * The hand is made up: it presses from above into the middle of the object and comes out again, once a second. With a device of yours, read its
 * position where `hand_at` stands, and give `felt.force_n` to its motors. TRACE gets all ticks; `isotouch replay FIELD TRACE --check` computes them again.
 */
#define _POSIX_C_SOURCE 200809L

#include <isotouch.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define PERIOD_NS 1000000L

static int failed(const char* what) {
  fprintf(stderr, "loop: %s: %s\n", what, isotouch_last_error());
  return 1;
}

/* From above the object to its middle and back, once a second. */
static void hand_at(double seconds, const isotouch_field_facts* object, double hip_mm[3]) {
  const double pi = 3.14159265358979323846, down = 0.5 - 0.5 * cos(2 * pi * seconds);
  int axis;
  for (axis = 0; axis < 3; ++axis) hip_mm[axis] = (object->low_mm[axis] + object->high_mm[axis]) / 2;
  hip_mm[1] = object->high_mm[1] + down * (hip_mm[1] - object->high_mm[1]);
}

static void sleep_until(struct timespec* next) {
  next->tv_nsec += PERIOD_NS;
  if (next->tv_nsec >= 1000000000L) {
    next->tv_nsec -= 1000000000L;
    ++next->tv_sec;
  }
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, next, NULL) != 0) {
  }
}

int main(int argc, char** argv) {
  isotouch_field field = 0;
  isotouch_touch touch = 0;
  isotouch_field_facts object;
  isotouch_settings settings;
  isotouch_felt felt;
  struct timespec next;
  uint64_t kept = 0;
  long tick, ticks, touching = 0;
  double largest = 0;

  if (argc < 3 || argc > 4) {
    fprintf(stderr, "usage: loop FIELD TRACE [SECONDS]\n");
    return 2;
  }
  ticks = lround(1000 * (argc > 3 ? atof(argv[3]) : 2));
  if (ticks < 1 || ticks > 3600000) {
    fprintf(stderr, "loop: SECONDS must be from 0.001 to 3600\n");
    return 2;
  }

  if (isotouch_field_load(argv[1], &field) != ISOTOUCH_OK) return failed("no field");
  if (isotouch_field_describe(field, &object, sizeof object) != ISOTOUCH_OK) return failed("no facts");
  if (isotouch_settings_default(&settings, sizeof settings) != ISOTOUCH_OK) return failed("no settings");
  settings.friction = 0.2;
  settings.record_ticks = (uint64_t)ticks;
  if (isotouch_touch_new(field, &settings, sizeof settings, &touch) != ISOTOUCH_OK) return failed("no touch");

  clock_gettime(CLOCK_MONOTONIC, &next);
  for (tick = 0; tick < ticks; ++tick) {
    double hip_mm[3], force;
    hand_at((double)tick / 1000, &object, hip_mm);
    if (isotouch_touch_position(touch, hip_mm, 0, &felt, sizeof felt) != ISOTOUCH_OK) return failed("no tick");
    force = sqrt(felt.force_n[0] * felt.force_n[0] + felt.force_n[1] * felt.force_n[1] + felt.force_n[2] * felt.force_n[2]);
    if (force > largest) largest = force;
    touching += (long)felt.contact;
    sleep_until(&next);
  }

  if (isotouch_touch_save(touch, argv[2], &kept) != ISOTOUCH_OK) return failed("no trace");
  printf("%ld ticks, %ld in contact, largest force %.3f N, %lu ticks in %s\n", ticks, touching, largest, (unsigned long)kept, argv[2]);
  isotouch_free(touch);
  isotouch_free(field);
  return 0;
}
