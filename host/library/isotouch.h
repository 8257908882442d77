/**
 * @file isotouch.h
 * The C interface of isotouch: load a field, sample it, touch it, read traces, and speak with a running controller. C99 and newer, C++98 and newer.
 *
 * **Units and frame.** Lengths are mm, forces N, stiffnesses N/mm, damping N s/mm. Positions are in the workspace: x right, y up, z towards the
 * person, origin in its middle. Distances are negative inside the object, gradients point out. Three numbers of a place are x, y, z.
 *
 * **Errors.** Every function that can fail returns an #isotouch_status. On failure nothing that the caller passed was changed, unless the function says
 * otherwise, and isotouch_last_error() has one sentence. Null pointers, wrong sizes, numbers that are not finite and handles that were freed are errors.
 *
 * **Handles.** A handle is a number and never an address; 0 is none. isotouch_free() ends it. A handle that was freed, that is another kind of thing, or
 * that never was, gives #ISOTOUCH_BAD_HANDLE. At most 4096 exist at a time.
 *
 * **Threads.** Every function may be called from every thread. Fields and traces may be used by several threads at once. A touch or a controller that
 * another thread is using, and what is freed while it is used, gives #ISOTOUCH_BUSY; nothing waits.
 *
 * **Processes.** After fork() both processes may go on with their handles, if no other thread was in a call at that moment. In the new process a controller
 * is connected to anew.
 *
 * **Sizes.** Each structure is passed with its size, so that a later version may add members at its end and still take the sizes of earlier ones. A size
 * that this library does not know is an error, such as that of a newer header.
 *
 * **Real time.** Functions marked "real time: yes" allocate nothing, lock nothing, make no system call and take constant time as long as they succeed. All
 * others may allocate and block.
 */
#ifndef ISOTOUCH_H
#define ISOTOUCH_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define ISOTOUCH_API __attribute__((visibility("default")))
#else
#define ISOTOUCH_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What a function returns. */
typedef enum isotouch_status {
  ISOTOUCH_OK = 0,
  ISOTOUCH_BAD_ARGUMENT = 1, /**< a null pointer, a wrong size, a number that is not finite or out of range */
  ISOTOUCH_BAD_HANDLE = 2,   /**< freed, of another kind, or never given out */
  ISOTOUCH_BUSY = 3,         /**< another thread is using it */
  ISOTOUCH_BAD_DATA = 4,     /**< a file, or bytes, cannot be read, written, or are refused */
  ISOTOUCH_MISSING = 5,      /**< this trace does not hold what was asked for */
  ISOTOUCH_TOO_SMALL = 6,    /**< a text needs more room than there is */
  ISOTOUCH_CONTROLLER = 7,   /**< the controller does not answer, or refuses */
  ISOTOUCH_NO_MEMORY = 8,    /**< out of memory, or of handles */
  ISOTOUCH_INTERNAL = 9      /**< a mistake in this library; please report its sentence */
} isotouch_status;

typedef uint64_t isotouch_field;      /**< a field in memory */
typedef uint64_t isotouch_touch;      /**< a hand on a field */
typedef uint64_t isotouch_trace;      /**< a recording in memory */
typedef uint64_t isotouch_controller; /**< a running `isotouchd` */

/**
 * What the last call of this thread that failed has to say: one sentence, what is wrong and what to do. Empty where none has failed.
 *
 * @return text in UTF-8 that stays until the next call of this thread fails
 *
 * Real time: yes.
 */
ISOTOUCH_API const char* isotouch_last_error(void);

/** Program, version and commit, as "isotouch X.Y.Z, commit …". Without memory for it, a sentence that says so. */
ISOTOUCH_API const char* isotouch_version(void);

/**
 * Sets the sentence of isotouch_last_error(), for libraries and bindings on top of this one.
 *
 * @param status    is returned
 * @param sentence  is copied and cut at 1000 bytes; null counts as empty
 */
ISOTOUCH_API isotouch_status isotouch_fail(isotouch_status status, const char* sentence);

/**
 * Ends a handle of any kind. What other handles need of it stays: a field may be freed while it is touched.
 *
 * @param handle  0 is none, and nothing happens
 */
ISOTOUCH_API isotouch_status isotouch_free(uint64_t handle);

/* ---- fields ---------------------------------------------------------------------------------------------------------------------------- */

/** What a field is between its samples. */
typedef enum isotouch_interpolation {
  ISOTOUCH_SPLINE = 0,   /**< a quadratic B-spline */
  ISOTOUCH_TRILINEAR = 1 /**< linear along each axis */
} isotouch_interpolation;

/** What a field says of itself. */
typedef struct isotouch_field_facts {
  uint64_t hash;                 /**< of its image: XXH64, as `isotouch info` shows it */
  uint64_t image_bytes;          /**< in memory */
  double low_mm[3];              /**< corner of the sampled box */
  double high_mm[3];             /**< the opposite corner */
  double voxel_mm;               /**< edge of a voxel */
  double band_mm;                /**< half the width of the layer round the surface in which distances are stored */
  double stiffness_n_mm;         /**< of the surface; where it varies, the largest */
  double advised_stiffness_n_mm; /**< largest advisable one by its certificate; 0 = it has none */
  double scale;                  /**< workspace = scale × scan + offset; 0: not stated */
  double offset_mm[3];           /**< zeros where scale is 0 */
  uint32_t samples[3];           /**< along x, y, z */
  uint32_t interpolation;        /**< #isotouch_interpolation */
  uint32_t is_published;         /**< 1: levels of the published method, felt by its descent */
  uint32_t varies_in_stiffness;  /**< 1: it has a stiffness for each brick */
} isotouch_field_facts;

/**
 * Loads a field file (.itf, .itfi) and checks it as a controller does: every byte, every index, its certificate.
 *
 * @param path   in UTF-8
 * @param field  receives the handle
 */
ISOTOUCH_API isotouch_status isotouch_field_load(const char* path, isotouch_field* field);

/** The same from the bytes of such a file, which are copied. */
ISOTOUCH_API isotouch_status isotouch_field_read(const void* bytes, size_t size, isotouch_field* field);

/** Writes the packed form (.itf): the whole file or none. */
ISOTOUCH_API isotouch_status isotouch_field_save(isotouch_field field, const char* path);

/**
 * @param size  sizeof(isotouch_field_facts)
 */
ISOTOUCH_API isotouch_status isotouch_field_describe(isotouch_field field, isotouch_field_facts* facts, size_t size);

/**
 * Samples a field as the controller's tick does, with its integer arithmetic.
 *
 * @param count        number of points
 * @param points_mm    3 × count numbers, finite; a point outside the sampled box gets the distance of the box's border
 * @param distance_mm  count numbers, within ± the band; negative inside. Null: not wanted
 * @param gradient     3 × count numbers: slope of the distance, mm a mm, points out; zero beyond the band. Null: not wanted
 * @param stiffness    count numbers, N/mm, of the surface near the point. Null: not wanted
 * @param in_band      count bytes: 1 where distance and gradient are known, which is up to a voxel before the band ends; 0 where the surface may
 *                     be farther away, and in another direction. Null: not wanted
 *
 * Real time: yes, but for a time that grows with count.
 */
ISOTOUCH_API isotouch_status isotouch_field_sample(isotouch_field field, size_t count, const double* points_mm, double* distance_mm,
                                                   double* gradient, double* stiffness, uint8_t* in_band);

/* ---- touching -------------------------------------------------------------------------------------------------------------------------- */

/** Which published numbers of a Falcon turn encoder counts into positions and forces into motor commands. */
typedef enum isotouch_device { ISOTOUCH_LIBNIFALCON = 0, ISOTOUCH_MARTIN_HILLIER = 1 } isotouch_device;

/** How a field feels, and what is kept of it. Ranges are those of the controller's settings (`isotouchd --print-config`). */
typedef struct isotouch_settings {
  uint64_t record_ticks;    /**< ticks kept for isotouch_touch_save(), the first ones: at most 10,000,000, about 150 bytes each */
  uint32_t period_ns;       /**< ns, from one tick to the next: 100,000 to 4,000,000; 1,000,000 unless set */
  uint32_t device;          /**< #isotouch_device */
  double play_mm;           /**< mm; a smaller movement of the hand counts as rest: 0 to 1; 0.046 unless set, a Falcon's encoder count */
  double stiffness;         /**< N/mm, 0.001 to 100, or 0: the field's own */
  double damping;           /**< N s/mm, between proxy and hand: 0 to 0.1 */
  double force_limit_n;     /**< N, largest force of the object: 0 to 50; 8 unless set */
  double friction;          /**< Coulomb's coefficient, a ratio: 0 to 1.5 */
  double friction_damping;  /**< N s/mm, of a hand that slides: 0 to 0.1 */
  double hand_damping;      /**< N s/mm, of a hand in contact: 0 to 0.1 */
  double passivity_damping; /**< N s/mm, the largest that may be added against trembling: 0 to 0.1 */
  double weight_n;          /**< N, weight of the handle that the motors hold up: -5 to 5; only with encoder counts */
  double ramp_ticks;        /**< ticks from no force to full force if contact did not begin at rest: 0 to 100,000; 50 unless set */
  double device_damping;    /**< N s/mm, of the device itself: 0.0001 to 0.1, or 0: not known, and no stiffness is refused */
  double delay_ticks;       /**< ticks from a sample to its force being felt: 0 to 7 */
} isotouch_settings;

/** State of the supervisor, for a hand on a device. */
typedef enum isotouch_state {
  ISOTOUCH_BOOT = 0,   /**< no valid packet yet */
  ISOTOUCH_HOMING = 1, /**< the counts have no reference */
  ISOTOUCH_IDLE = 2,   /**< no field */
  ISOTOUCH_READY = 3,  /**< active in the next tick */
  ISOTOUCH_ACTIVE = 4, /**< forces */
  ISOTOUCH_HOLD = 5,   /**< no force; ends by itself */
  ISOTOUCH_FAULT = 6   /**< no force until it is resumed */
} isotouch_state;

/** What is true in a tick, one bit each; a limit at work is no fault. */
typedef enum isotouch_status_bit {
  ISOTOUCH_STATUS_CONTACT = 1 << 0,           /**< the surface holds the proxy back */
  ISOTOUCH_STATUS_FOLLOWING = 1 << 1,         /**< the proxy is on its way to the hand in free space: no force */
  ISOTOUCH_STATUS_OUTSIDE_GRID = 1 << 2,      /**< the hand is outside the sampled box */
  ISOTOUCH_STATUS_HELD_INSIDE = 1 << 3,       /**< the hand began inside the object: no force until it has left */
  ISOTOUCH_STATUS_RAMPING = 1 << 4,           /**< the force is below its full value, because contact did not begin at rest */
  ISOTOUCH_STATUS_FORCE_LIMITED = 1 << 5,     /**< the force was shortened to the limit, its direction kept */
  ISOTOUCH_STATUS_STALE = 1 << 6,             /**< no fresh sample came */
  ISOTOUCH_STATUS_INPUT_CLAMPED = 1 << 7,     /**< the hand was outside ±512 mm and was moved to the border */
  ISOTOUCH_STATUS_BAD_REPLY = 1 << 8,         /**< the device's packet was malformed and counts as none */
  ISOTOUCH_STATUS_COUNT_JUMP = 1 << 9,        /**< the encoders took another reference: the pose is sought anew */
  ISOTOUCH_STATUS_POSE_UNCERTAIN = 1 << 10,   /**< it is not known where the hand is: no force */
  ISOTOUCH_STATUS_NEAR_SINGULAR = 1 << 11,    /**< the arms are nearly stretched: torques are smaller than asked for */
  ISOTOUCH_STATUS_TOO_FAST = 1 << 12,         /**< the hand is faster than the device's limit */
  ISOTOUCH_STATUS_COMMANDS_LIMITED = 1 << 13, /**< the motor commands were shortened to the limit */
  ISOTOUCH_STATUS_SLEW_LIMITED = 1 << 14,     /**< the change of the motor commands was shortened */
  ISOTOUCH_STATUS_HEAT_LIMITED = 1 << 20,     /**< the motors are warm, and their limit is lowered */
  ISOTOUCH_STATUS_LATE = 1 << 21,             /**< periods were left out before this tick */
  ISOTOUCH_STATUS_DAMPED = 1 << 24,           /**< the passivity controller adds damping */
  ISOTOUCH_STATUS_LAGGING = 1 << 25           /**< the surface has moved by itself, and the force has not followed yet */
} isotouch_status_bit;

/** Why the supervisor is in fault, one bit each; kept until it is resumed. */
typedef enum isotouch_fault_bit {
  ISOTOUCH_FAULT_STOPPED = 1 << 0,     /**< somebody asked for it */
  ISOTOUCH_FAULT_SILENT = 1 << 1,      /**< no fresh sample for too long */
  ISOTOUCH_FAULT_PENETRATION = 1 << 2, /**< the hand was too deep in the object */
  ISOTOUCH_FAULT_ENCODERS = 1 << 3,    /**< the encoders jumped while there was force */
  ISOTOUCH_FAULT_POSE = 1 << 4,        /**< it was not known for too long where the hand is */
  ISOTOUCH_FAULT_SPEED = 1 << 5,       /**< the hand was too fast for too long */
  ISOTOUCH_FAULT_LATE = 1 << 6,        /**< ticks were late for too long */
  ISOTOUCH_FAULT_EMERGENCY = 1 << 7,   /**< the emergency stop */
  ISOTOUCH_FAULT_ENABLE = 1 << 8,      /**< the motors' enable line reads back wrong */
  ISOTOUCH_FAULT_MEMORY = 1 << 9,      /**< memory has changed by itself */
  ISOTOUCH_FAULT_GUARD = 1 << 10       /**< the guard took the force away */
} isotouch_fault_bit;

/** What one tick answers. */
typedef struct isotouch_felt {
  uint64_t tick;    /**< counted from 0 */
  double hip_mm[3]; /**< where the hand is; of encoder counts zeros as long as that is not known, as in ISOTOUCH_BOOT and ISOTOUCH_HOMING */
  double proxy_mm[3];    /**< the point on the surface that the hand is held by; in free space the hand itself */
  double force_n[3];     /**< on the hand */
  double penetration_mm; /**< from the hand to the proxy in contact, else 0 */
  uint32_t contact;      /**< 1: the surface holds the proxy back */
  uint32_t status;       /**< #isotouch_status_bit */
  uint32_t state;        /**< #isotouch_state; of positions always 0: there is no device that could be unsafe */
  uint32_t faults;       /**< #isotouch_fault_bit; of positions always 0 */
  uint32_t buttons;      /**< bits 0 to 3 */
  int32_t commands[3];   /**< motor commands, legs top, right, left; of positions always 0 */
} isotouch_felt;

/** For isotouch_touch_request(); each holds for the next tick. */
enum { ISOTOUCH_STOP = 1, ISOTOUCH_RESUME = 2 };

/**
 * Sets every member to its default.
 *
 * @param size  sizeof(isotouch_settings)
 */
ISOTOUCH_API isotouch_status isotouch_settings_default(isotouch_settings* settings, size_t size);

/**
 * A hand that begins to touch a field. All memory is taken here.
 *
 * @param field     may be freed afterwards
 * @param settings  null: the defaults
 * @param size      sizeof(isotouch_settings); 0 where settings is null
 *
 * Refused (#ISOTOUCH_BAD_DATA) is what a controller refuses: a stiffness above what period, delay and damping of the device allow, if the damping is
 * given.
 */
ISOTOUCH_API isotouch_status isotouch_touch_new(isotouch_field field, const isotouch_settings* settings, size_t size,
                                                isotouch_touch* touch);

/**
 * One tick of a hand without a device: its position goes in, the force comes out.
 *
 * @param hip_mm   3 numbers, finite; beyond 512 mm it is moved to that border and a status bit is set
 * @param buttons  bits 0 to 3, for the trace
 * @param size     sizeof(isotouch_felt)
 *
 * Fails (#ISOTOUCH_BAD_ARGUMENT) where this touch has begun with encoder counts. Real time: yes.
 */
ISOTOUCH_API isotouch_status isotouch_touch_position(isotouch_touch touch, const double* hip_mm, uint32_t buttons, isotouch_felt* felt,
                                                     size_t size);

/**
 * One tick of a device: its encoder counts go in, motor commands come out, by the whole way of a controller with its supervisor.
 *
 * @param counts   3 counts, legs top, right, left, within the 16 bits of the device; they rise when an arm swings outwards
 * @param homed    bits 0 to 2: this leg has its reference
 * @param buttons  bits 0 to 3
 * @param size     sizeof(isotouch_felt)
 *
 * Fails (#ISOTOUCH_BAD_ARGUMENT) where this touch has begun with positions. Real time: yes.
 */
ISOTOUCH_API isotouch_status isotouch_touch_counts(isotouch_touch touch, const int32_t* counts, uint32_t homed, uint32_t buttons,
                                                   isotouch_felt* felt, size_t size);

/**
 * One tick for which no new sample came: the last one is used again and is a tick older. With encoder counts a few of them stop the force.
 *
 * Fails (#ISOTOUCH_BAD_ARGUMENT) before the first sample. Real time: yes.
 */
ISOTOUCH_API isotouch_status isotouch_touch_missed(isotouch_touch touch, isotouch_felt* felt, size_t size);

/**
 * What a person asks of the next tick of a device; with positions it has no effect.
 *
 * Requests before the same tick add up, and a stop counts more than a resume.
 *
 * @param requests  ISOTOUCH_STOP: no force until it is resumed; ISOTOUCH_RESUME: leave a fault; or both
 *
 * Real time: yes.
 */
ISOTOUCH_API isotouch_status isotouch_touch_request(isotouch_touch touch, uint32_t requests);

/**
 * A tick for each position of a path.
 *
 * @param ticks   number of positions
 * @param hip_mm  3 × ticks numbers, finite; all are looked at before the first tick
 * @param felt    ticks structures
 * @param size    sizeof(isotouch_felt) × ticks
 */
ISOTOUCH_API isotouch_status isotouch_touch_path(isotouch_touch touch, size_t ticks, const double* hip_mm, isotouch_felt* felt,
                                                 size_t size);

/**
 * Writes the ticks that were kept as a trace, which `isotouch replay FIELD TRACE --check` computes again to the bit: the whole file or none.
 *
 * @param ticks  receives how many were kept; fewer than were felt where record_ticks was too small. Null: not wanted
 *
 * Fails (#ISOTOUCH_MISSING) where none were kept.
 */
ISOTOUCH_API isotouch_status isotouch_touch_save(isotouch_touch touch, const char* path, uint64_t* ticks);

/** "boot" to "fault"; "unknown" for a number that is no #isotouch_state. Real time: yes. */
ISOTOUCH_API const char* isotouch_state_name(uint32_t state);

/* ---- traces ---------------------------------------------------------------------------------------------------------------------------- */

/** What a trace says of itself. */
typedef struct isotouch_trace_facts {
  uint64_t ticks;
  uint64_t field_hash;  /**< of the field that was touched; 0 = none, or not named */
  uint64_t replay_hash; /**< the chain after the last tick; 0 where there are no outputs */
  uint32_t period_ns;
  uint32_t has_packets; /**< 1: packets of a device; 0: positions of a hand */
  uint32_t has_outputs; /**< 1: forces, proxies and commands are recorded */
  uint32_t is_cut_off;  /**< 1: the file ends before it should; the whole ticks of it are here */
} isotouch_trace_facts;

/** Loads and checks a whole trace file. A recording that was changed after it was recorded is refused. */
ISOTOUCH_API isotouch_status isotouch_trace_load(const char* path, isotouch_trace* trace);

/** @param size  sizeof(isotouch_trace_facts) */
ISOTOUCH_API isotouch_status isotouch_trace_describe(isotouch_trace trace, isotouch_trace_facts* facts, size_t size);

/** Number of columns that a trace may have. Real time: yes. */
ISOTOUCH_API size_t isotouch_trace_columns(void);

/**
 * Name of a column, as `isotouch trace show --columns` knows it, where `packet` is one more; null beyond the last. Real time: yes.
 *
 * @param is_integer  receives 1 where every value is a whole number, else 0. Null: not wanted
 */
ISOTOUCH_API const char* isotouch_trace_column(size_t column, uint32_t* is_integer);

/**
 * Values of a column. States, guard verdicts and kinds of input are numbers here.
 *
 * @param column  its name
 * @param first   tick of the first value
 * @param count   number of values; all of them must be ticks of the trace
 * @param values  count numbers; a value that a single tick lacks is NaN
 *
 * Fails (#ISOTOUCH_MISSING) where no tick of this trace has the column: outputs of a trace of inputs, or a device's numbers with positions.
 */
ISOTOUCH_API isotouch_status isotouch_trace_doubles(isotouch_trace trace, const char* column, uint64_t first, size_t count, double* values);

/** The same of a column of whole numbers; a value that a single tick lacks is -1. 64-bit hashes are given by their bits. */
ISOTOUCH_API isotouch_status isotouch_trace_integers(isotouch_trace trace, const char* column, uint64_t first, size_t count,
                                                     int64_t* values);

/* ---- a running controller -------------------------------------------------------------------------------------------------------------- */

/**
 * Connects to a controller. After a call that failed, the next one connects again. The ssh to a far controller ignores the terminal's Ctrl-C.
 *
 * @param address     `unix:PATH` of its socket, or `ssh://user@host[:port][/path of the socket]`
 * @param timeout_ms  longest time to wait for an answer, 1 to 3,600,000
 */
ISOTOUCH_API isotouch_status isotouch_controller_connect(const char* address, uint32_t timeout_ms, isotouch_controller* controller);

/**
 * Its state, faults, field and times, as `isotouch status --json` prints them.
 *
 * @param json      receives the text with a zero at its end; null where capacity is 0
 * @param capacity  bytes of room
 * @param needed    receives the bytes that the text takes, with its zero. Null: not wanted
 *
 * Fails (#ISOTOUCH_TOO_SMALL) where it does not fit; `needed` is set then, too.
 */
ISOTOUCH_API isotouch_status isotouch_controller_status(isotouch_controller controller, char* json, size_t capacity, size_t* needed);

/**
 * Changes a setting of how it feels while it is felt.
 *
 * @param name   as in the section [feel] of the settings file, such as "friction"
 * @param value  as it is written there, such as "0.3"
 */
ISOTOUCH_API isotouch_status isotouch_controller_set(isotouch_controller controller, const char* name, const char* value);

/**
 * Sends a field; it is felt when this returns. When it is refused, the field before stays. When it fails because no answer came in time, the controller may
 * still take it: isotouch_controller_status() says which field is felt.
 *
 * @param name  under which the controller stores it, at most 63 bytes
 */
ISOTOUCH_API isotouch_status isotouch_controller_upload(isotouch_controller controller, isotouch_field field, const char* name);

/** No force from the next tick on, until it is resumed. */
ISOTOUCH_API isotouch_status isotouch_controller_stop(isotouch_controller controller);

/** Leaves a fault, if its cause is gone; the force rises from zero. */
ISOTOUCH_API isotouch_status isotouch_controller_resume(isotouch_controller controller);

/** Gets a tick of the controller. Another number than 0 ends what it follows. */
typedef int (*isotouch_on_tick)(void* user, const isotouch_felt* felt);

/**
 * Follows the ticks, over a connection of its own: other calls with this handle may be made meanwhile, also in on_tick. The controller closes this
 * connection where an on_tick takes longer than 10 s.
 *
 * @param every    1 for every tick, 10 for one in ten; at least 1
 * @param ticks    how many ticks on_tick gets before the call returns
 * @param on_tick  is called in this thread, once for each of them; `felt->tick` is the controller's own count. A number other than 0 ends the
 *                 call early, with success
 * @param user     is passed on to on_tick
 * @param lost     receives how many of them the controller dropped because this program read too slowly, also where the
 *                 connection ends before; 0 where the call fails otherwise. Null: not wanted
 *
 * Fails (#ISOTOUCH_CONTROLLER) where the connection ends before.
 */
ISOTOUCH_API isotouch_status isotouch_controller_watch(isotouch_controller controller, uint32_t every, uint64_t ticks,
                                                       isotouch_on_tick on_tick, void* user, uint64_t* lost);

/**
 * Records ticks from now on as a trace that replays, over a connection of its own, which the controller closes as that of isotouch_controller_watch().
 *
 * @param ticks     how many, at least 1
 * @param path      of the trace file. If the recording ends early, the file holds the ticks until then; unless on_tick ended it, the call fails
 * @param on_tick   is called in this thread, once for each tick in the file, whose number in `felt->tick` counts from 0; a number other than 0
 *                  ends the recording after this tick, with success. Null: not wanted
 * @param user      is passed on to on_tick
 * @param recorded  receives the number of ticks in the file, also when it fails. Null: not wanted
 */
ISOTOUCH_API isotouch_status isotouch_controller_record(isotouch_controller controller, uint64_t ticks, const char* path,
                                                        isotouch_on_tick on_tick, void* user, uint64_t* recorded);

#ifdef __cplusplus
}
#endif

#endif
