/** @file engine.h
 *  The first of the two roots: an engine owns plugins, shapes, the allocator and the log. Any number may exist.
 */
#ifndef CAROM_ENGINE_H
#define CAROM_ENGINE_H

#include <carom/base.h>
#include <carom/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct carom_engine carom_engine;

#define CAROM_LOG_INFO 1u
#define CAROM_LOG_WARNING 2u
#define CAROM_LOG_ERROR 3u

/** What an engine is made from. Fill with carom_engine_desc_init(), then change what you need. */
typedef struct carom_engine_desc {
  uint32_t struct_size;
  uint32_t reserved; /**< 0 */
  /** Host allocator, both or neither; NULL for the C library's. alloc returns NULL when out of memory; alignment is a power
   *  of two. Called on whichever threads use the engine and its worlds, at once. */
  void *(*alloc)(void *user, uint64_t size, uint64_t alignment);
  void (*free)(void *user, void *pointer, uint64_t size, uint64_t alignment);
  void *alloc_user;
  /** Host log, or NULL for silence. */
  void (*log)(void *user, uint32_t level, const char *text);
  void *log_user;
} carom_engine_desc;

/** @status OK; NULL_ARGUMENT */
CAROM_API int32_t carom_engine_desc_init(carom_engine_desc *desc);

/** Make an engine. @param desc may be NULL: defaults.   @owns the caller: carom_engine_destroy()
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; LIMIT (65,535 engines and worlds in all); OUT_OF_MEMORY
 *  @thread any */
CAROM_API int32_t carom_engine_create(const carom_engine_desc *desc, carom_engine **engine, carom_error *error);

/** Destroy an engine; its worlds must be gone.   @status OK; NULL_ARGUMENT; IN_USE (destroy its worlds first); REENTRANT */
CAROM_API int32_t carom_engine_destroy(carom_engine *engine, carom_error *error);

/** Load a shape plugin from a shared object. @param path absolute.
 *  The plugin is checked before anything is called, then asked for supports in 256 directions with parameters that the
 *  bounds allow. Loading the same path twice is ALREADY_EXISTS.
 *  @status OK; NULL_ARGUMENT; PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_DISHONEST; ALREADY_EXISTS; OUT_OF_MEMORY
 *  @thread any, also while worlds step */
CAROM_API int32_t carom_plugin_load(carom_engine *engine, const char *path, carom_plugin *plugin, carom_error *error);

/** Register a plugin by pointer: static linking, WebAssembly, or a shape written in the host's language.
 *  The struct and all it points to must outlive the engine.   @status as carom_plugin_load() */
CAROM_API int32_t carom_plugin_register(carom_engine *engine, const carom_shape_plugin *description,
                                        carom_plugin *plugin, carom_error *error);

/** Forget a plugin (logically: the code stays mapped).   @status OK; IN_USE (shapes of it live); *_HANDLE; REENTRANT */
CAROM_API int32_t carom_plugin_unload(carom_engine *engine, carom_plugin plugin, carom_error *error);

/** Find a loaded plugin by its id.   @status OK; NULL_ARGUMENT; NOT_FOUND (load it first) */
CAROM_API int32_t carom_plugin_find(carom_engine *engine, const char *id, carom_plugin *plugin, carom_error *error);

/** The plugin's own description: documentation, declarations, function. Valid while the engine lives.
 *  @status OK; NULL_ARGUMENT; *_HANDLE */
CAROM_API int32_t carom_plugin_describe(carom_engine *engine, carom_plugin plugin,
                                        const carom_shape_plugin **description, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
