/** @file engine.h
 *  The first of the two roots: an engine owns plugins, shapes, the allocator and the log. Any number may exist.
 *  @thread engine: a call that takes an engine may run on any thread, also while worlds of the engine step: look-ups
 *  have a lock. A call that takes neither an engine nor a world may run at any time.
 */
#ifndef CAROM_ENGINE_H
#define CAROM_ENGINE_H

#include <carom/base.h>
#include <carom/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct carom_engine carom_engine;

#define CAROM_LOG_INFO 1u    /* what happened */
#define CAROM_LOG_WARNING 2u /* what may surprise: the call succeeded */
#define CAROM_LOG_ERROR 3u   /* not used so far: a call that fails says so by its result */

/** What an engine is made from. Fill with carom_engine_desc_init(), then change what you need. */
typedef struct carom_engine_desc {
  uint32_t struct_size;
  uint32_t reserved; /**< 0 */
  /** Host allocator, both or neither; NULL for the C library's. alloc returns NULL when out of memory; alignment is a
   *  power of two. Called on whichever threads use the engine and its worlds, at once. */
  void *(*alloc)(void *user, uint64_t size, uint64_t alignment);
  /** Takes back what alloc gave, with the same size and alignment. */
  void (*free)(void *user, void *pointer, uint64_t size, uint64_t alignment);
  void *alloc_user; /**< handed to alloc and free */
  /** Host log, or NULL for silence. */
  void (*log)(void *user, uint32_t level, const char *text);
  void *log_user; /**< handed to log */
} carom_engine_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_engine_desc_init(carom_engine_desc *desc, uint32_t struct_size);

/** Make an engine. @param desc may be NULL: defaults.   @owns the caller: carom_engine_destroy()
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; LIMIT (65,535 engines and worlds in all); OUT_OF_MEMORY */
CAROM_API int32_t carom_engine_create(const carom_engine_desc *desc, carom_engine **engine, carom_error *error);

/** Destroy an engine; its worlds, batches and devices must be gone.   @status OK; NULL_ARGUMENT; IN_USE (destroy its worlds, batches and devices first);
 *  REENTRANT   @thread writer: no other call may use the engine */
CAROM_API int32_t carom_engine_destroy(carom_engine *engine, carom_error *error);

/** Do the parts [begin, end) of a loop. Does not call back, throw or block.
 *  @param context as run got it   @param begin, end range of parts */
typedef void (*carom_job_fn)(void *context, uint32_t begin, uint32_t end);

/** Which threads share the work of a step. The outcome does not depend on it: same bits for any number of threads.
 *  Fill with carom_jobs_desc_init(), then change what you need. */
typedef struct carom_jobs_desc {
  uint32_t struct_size;
  /** Threads in a step, the one that calls carom_world_step() included: 0 or 1, the default, is that one alone; more
   *  are a pool that the engine owns, at most 256. Worlds that step at the same time do not wait for it: one of them
   *  has it. */
  uint32_t threads;
  /** Or the host's own threads (threads is then 0): see to it that job(context, begin, end) is called for ranges that
   *  cover [0, count), on any threads at once, and return when all these calls have returned. Called on the thread that
   *  steps, and tens of times a step: waking a thread should not take longer than some microseconds. Parts that are
   *  left out are done when it returns, those that come twice are done once. Calls of carom_* from inside a
   *  part, or from run itself, are REENTRANT. */
  void (*run)(void *user, carom_job_fn job, void *context, uint32_t count);
  void *user; /**< handed to run */
} carom_jobs_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_jobs_desc_init(carom_jobs_desc *desc, uint32_t struct_size);

/** Say which threads share the work of steps in the engine's worlds, before the first of them is made. Support
 *  functions are then called, and the allocator may be, on those threads; those of HOST_THREAD plugins are still called
 *  on the stepping one.
 *  @param desc may be NULL: the stepping thread alone
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; OUT_OF_RANGE; IN_USE (worlds, batches or devices are
 *  alive, or carom_pairs_distance() is under way); LIMIT (the system has no more threads); OUT_OF_MEMORY; REENTRANT */
CAROM_API int32_t carom_engine_set_jobs(carom_engine *engine, const carom_jobs_desc *desc, carom_error *error);

/** Load a shape plugin from a shared object. @param path absolute.
 *  The plugin is checked before anything is called, then by its support points in 256 directions, with parameters that
 *  the bounds allow. Loading the same path twice is ALREADY_EXISTS.
 *  @status OK; NULL_ARGUMENT; PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; ALREADY_EXISTS; OUT_OF_MEMORY */
CAROM_API int32_t carom_plugin_load(carom_engine *engine, const char *path, carom_plugin *plugin, carom_error *error);

/** Register a plugin by pointer: static linking, WebAssembly, or a shape written in the host's language.
 *  The struct and all it points to must outlive the engine.   @status as carom_plugin_load() */
CAROM_API int32_t carom_plugin_register(carom_engine *engine, const carom_shape_plugin *description,
                                        carom_plugin *plugin, carom_error *error);

/** Register the plugins of plugins/ that are linked into the library: in an archive (carom::carom_static), in
 *  WebAssembly, and where it was built with CAROM_LINK_SHAPES. Those that the engine has already are left as they are.
 *  @status OK; NULL_ARGUMENT; UNSUPPORTED (none is linked in: load files, or name shapes); LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_plugins_register_standard(carom_engine *engine, carom_error *error);

/** Forget a plugin (logically: the code stays mapped).   @status OK; NULL_ARGUMENT; IN_USE (shapes of it live);
 *  *_HANDLE; REENTRANT */
CAROM_API int32_t carom_plugin_unload(carom_engine *engine, carom_plugin plugin, carom_error *error);

/** Find a loaded plugin by its id.
 *  @param id as in carom_shape_plugin.id
 *  @status OK; NULL_ARGUMENT; NOT_FOUND (load it first) */
CAROM_API int32_t carom_plugin_find(carom_engine *engine, const char *id, carom_plugin *plugin, carom_error *error);

/** The plugin's own description, as its author compiled it: documentation, declarations, function. Only fields within
 *  its struct_size are there. Valid while the engine lives.
 *  @status OK; NULL_ARGUMENT; *_HANDLE */
CAROM_API int32_t carom_plugin_describe(carom_engine *engine, carom_plugin plugin,
                                        const carom_shape_plugin **description, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
