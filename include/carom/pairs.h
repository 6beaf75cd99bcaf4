/** @file pairs.h
 *  Distances of many pairs of shapes in one call, without a world: carom_shape_distance() over arrays, on the host's
 *  threads or on a device of OpenCL. The bits are the same everywhere.
 *
 *  A device does the pairs whose cores are apart. It leaves the others to the host, which does them on the engine's
 *  threads: cores that overlap, half-spaces, scenery, what rounding keeps from an end, support functions that
 *  misbehave. carom_device_get_info() says how many.
 *
 *  A device speaks for closed forms (CAROM_FORM_*, a polytope among them) itself, as the host does. It asks any other
 *  shape by the text of its plugin's support function (CAROM_SUPPORT_TEXT()). That text is compiled by the device's
 *  driver, and believed where it gives the host's bits in 256 directions of the shape. A shape without such a text is
 *  refused on a device: UNSUPPORTED, with the reason.
 *  @thread engine: any thread, also while worlds of the engine step (engine.h).
 */
#ifndef CAROM_PAIRS_H
#define CAROM_PAIRS_H

#include <carom/query.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Pairs in the caller's arrays, at any stride (0: tightly packed). struct_size set by the caller, what is not set
 *  zero. */
typedef struct carom_pairs {
  uint32_t struct_size;
  uint32_t reserved;             /**< 0 */
  uint64_t count;                /**< pairs, at most 2^24 */
  const carom_shape *shapes_a;   /**< one each */
  const carom_shape *shapes_b;   /**< likewise */
  const double *positions_a;     /**< 3 each, m, world */
  const double *orientations_a;  /**< 4 each: x, y, z, w */
  const double *positions_b;     /**< 3 each, m, world */
  const double *orientations_b;  /**< 4 each: x, y, z, w */
  uint64_t shape_a_stride;       /**< bytes; 0: tightly packed */
  uint64_t shape_b_stride;       /**< likewise */
  uint64_t position_a_stride;    /**< likewise */
  uint64_t orientation_a_stride; /**< likewise */
  uint64_t position_b_stride;    /**< likewise */
  uint64_t orientation_b_stride; /**< likewise */
} carom_pairs;

/** Signed distance of each pair, on the engine's threads (carom_engine_set_jobs()). Each result has the bits that
 *  carom_shape_distance() gives for its pair, for any number of threads. All pairs are checked before the first result
 *  is written, and a message names the pair that is wrong. A pair whose support function misbehaves says so in its
 *  status (CAROM_QUERY_FAULT), and spoils no other. Nothing is allocated per pair.
 *  @param desc   may be NULL: defaults
 *  @param dst    out, [pairs->count]; no array of pairs
 *  @param stride sizeof(carom_distance) as the caller knows it; an older, shorter one gets its beginning. struct_size is
 *                written, too
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED (a
 *          pair of half-spaces or sceneries); BUFFER_TOO_SMALL (a stride); OUT_OF_MEMORY; INTERNAL (a callback left its
 *          thread: some results were written)
 *  @since 0.9 */
CAROM_API int32_t carom_pairs_distance(carom_engine *engine, const carom_pairs *pairs, const carom_distance_desc *desc,
                                       carom_distance *dst, uint64_t stride, carom_error *error);

/** What computes beside the host: a processor of OpenCL, which is loaded when the first is asked for. One call at a time
 *  uses it: a call on a device that another call uses is BUSY. */
typedef struct carom_device carom_device;

/** Open a device. Its arithmetic is tried, and it is refused where a number is rounded otherwise than on the host.
 *  @param index  among all devices of all platforms, in the order in which the system has them; 0 is the first
 *  @param device out: to be destroyed before the engine   @owns the caller: carom_device_destroy()
 *  @status OK; NULL_ARGUMENT; NOT_FOUND (no OpenCL, or no such device: the message says how many there are); UNSUPPORTED
 *          (it has no double precision, or rounds otherwise); OUT_OF_MEMORY
 *  @since 0.9 */
CAROM_API int32_t carom_device_create(carom_engine *engine, uint32_t index, carom_device **device, carom_error *error);

/** @param device from carom_device_create()   @status OK; NULL_ARGUMENT; BUSY; REENTRANT   @since 0.9 */
CAROM_API int32_t carom_device_destroy(carom_device *device, carom_error *error);

/** A device, and what it has done since it was opened. */
typedef struct carom_device_info {
  uint32_t struct_size;
  uint32_t reserved;
  char name[128];      /**< as its driver says, zero-terminated */
  char version[128];   /**< of OpenCL and the driver, zero-terminated */
  uint64_t pairs;      /**< that it was asked for */
  uint64_t host_pairs; /**< of them, left to the host */
} carom_device_info;

/** @param device from carom_device_create()   @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY   @since 0.9 */
CAROM_API int32_t carom_device_get_info(carom_device *device, carom_device_info *info, carom_error *error);

/** As carom_pairs_distance(), on a device: each result has the same bits. Shapes are of the device's engine.
 *  @param device from carom_device_create()
 *  @param desc   may be NULL: defaults
 *  @param dst    out, [pairs->count]; no array of pairs
 *  @param stride as carom_pairs_distance()
 *  @status as carom_pairs_distance(); UNSUPPORTED (a shape that a device cannot ask; CAROM_SIMPLEX_JOHNSON and routines of
 *          pairs, which devices have not; a driver that failed: some results may be written); BUSY; REENTRANT
 *  @since 0.9 */
CAROM_API int32_t carom_device_pairs_distance(carom_device *device, const carom_pairs *pairs,
                                              const carom_distance_desc *desc, carom_distance *dst, uint64_t stride,
                                              carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
