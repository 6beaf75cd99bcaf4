/** @file base.h
 *  What every other header stands on: export macro, version, result codes, error objects, handles.
 *
 *  Conventions of the whole interface: SI units (m, kg, s, rad); right-handed frames; quaternions cross as x, y, z, w;
 *  every call returns an int32_t result (CAROM_OK is 0, errors are negative) and, where its last argument is a
 *  carom_error*, writes the details there if it is not NULL. A call that fails has changed nothing.
 *  A struct that a call reads is filled with defaults by its *_init(&it, sizeof it) first: the size says which version
 *  of it the caller knows, and is STRUCT_SIZE where no version has it. Of a struct that a call fills, set struct_size
 *  to its sizeof before. The same checks run in Release and Debug builds. Nothing aborts, throws or prints across this
 *  boundary.
 *  Arguments and fields of these names mean the same everywhere:
 *    world          made by carom_world_create()
 *    engine         made by carom_engine_create()
 *    batch          made by carom_batch_create()
 *    struct_size    sizeof the struct, as the caller knows it
 *    reserved       0
 *    n              number of elements in the arrays
 *    capacity       number of elements that fit into dst
 *    count          number of elements
 *    dst            where the elements are written, NULL if capacity is 0
 *    stride         bytes from one element to the next
 *    *_stride       bytes from one element to the next; 0: tightly packed
 *    scalar         CAROM_SCALAR_*
 *    dial           CAROM_DIAL_*
 *    effect         CAROM_EFFECT_*
 *    coordinate     CAROM_COORDINATE_*
 *    attribute      CAROM_ATTRIBUTE_*
 *    user           handed back as it is
 *
 *  @thread any: a call that takes neither an engine nor a world may run on any thread, at any time.
 */
#ifndef CAROM_BASE_H
#define CAROM_BASE_H

#include <stdint.h>

#if defined(_WIN32)
#if defined(CAROM_BUILDING_LIBRARY)
#define CAROM_API __declspec(dllexport)
#else
#define CAROM_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define CAROM_API __attribute__((visibility("default")))
#else
#define CAROM_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_VERSION_MAJOR 0u /* of these headers */
#define CAROM_VERSION_MINOR 9u /* of these headers */
#define CAROM_VERSION_PATCH 0u /* of these headers */

/* ---- results: each has a name and a remedy, see carom_result_name() and carom_result_remedy() ---- */
#define CAROM_OK 0 /* the call did what it says */
/* clang-format off */
#define CAROM_E_NULL_ARGUMENT (-1)      /* a required pointer is NULL */
#define CAROM_E_NOT_FINITE (-2)         /* a number is NaN or infinite */
#define CAROM_E_OUT_OF_RANGE (-3)       /* a number is finite but outside its documented bounds */
#define CAROM_E_NOT_UNIT (-4)           /* a quaternion or normal is further than 1e-6 from unit length */
#define CAROM_E_UNKNOWN_ENUM (-5)       /* an enumeration value this library does not know */
#define CAROM_E_STRUCT_SIZE (-6)        /* struct_size is smaller than the smallest version of the struct */
#define CAROM_E_UNSUPPORTED (-7)        /* the request comes from a newer header, or asks for what this build cannot
                                           do */
#define CAROM_E_INVALID_HANDLE (-8)     /* the handle was never issued */
#define CAROM_E_STALE_HANDLE (-9)       /* the object behind the handle was destroyed */
#define CAROM_E_WRONG_KIND (-10)        /* a handle of another kind (a shape where a body is wanted, ...) */
#define CAROM_E_WRONG_WORLD (-11)       /* a handle of another world or engine */
#define CAROM_E_BUSY (-12)              /* another thread is stepping, changing or reading this world */
#define CAROM_E_REENTRANT (-13)         /* called from inside a callback (a support function, allocator or log) */
#define CAROM_E_IN_USE (-14)            /* the object is still referred to by others */
#define CAROM_E_OUT_OF_MEMORY (-15)     /* the allocator returned NULL */
#define CAROM_E_LIMIT (-16)             /* a hard limit of the library is reached */
#define CAROM_E_BUFFER_TOO_SMALL (-17)  /* stride or capacity does not hold one element */
#define CAROM_E_PLUGIN_PATH (-18)       /* the path is not absolute, or nothing readable is there */
#define CAROM_E_PLUGIN_LOAD (-19)       /* the dynamic loader refused the file, or the entry symbol is missing */
#define CAROM_E_PLUGIN_ABI (-20)        /* the plugin was built against an incompatible plugin.h */
#define CAROM_E_PLUGIN_INVALID (-21)    /* the support function is not one of a bounded convex set; see the witness */
#define CAROM_E_DECLARATION_FALSE (-22) /* a declaration disagrees with the support function; see the witness */
#define CAROM_E_NO_VOLUME (-23)         /* the body is flat, so no mass follows from a density */
#define CAROM_E_ALREADY_EXISTS (-24)    /* a plugin with this id is already loaded */
#define CAROM_E_NOT_FOUND (-25)         /* no object of this name */
#define CAROM_E_INTERNAL (-26)          /* a fault of the library itself; please report it */
#define CAROM_E_CORRUPT (-27)           /* bytes that are damaged, cut off or no snapshot */
#define CAROM_E_MISMATCH (-28)          /* a snapshot of a world with other things in it */
#define CAROM_E_WRITE_FAILED (-29)      /* a function that the host gave to write with said that it failed */
#define CAROM_E_READ_ONLY (-30)         /* a number of the library that is fixed, no dial */
/* clang-format on */

/** Details of the last failure of one call. Owned by the caller; start from CAROM_ERROR_INIT.
 *  Written only on failure, never past struct_size. */
typedef struct carom_error {
  uint32_t struct_size;  /**< sizeof(carom_error) as the caller knows it */
  int32_t code;          /**< CAROM_E_*, same as the returned result */
  int32_t argument;      /**< 1-based index of the argument at fault; 0: none in particular */
  uint32_t has_witness;  /**< 1: witness_dir and witness_out hold the evidence */
  double witness_dir[3]; /**< direction given to the support function */
  double witness_out[3]; /**< what came back */
  char message[256];     /**< what is wrong, zero-terminated */
  char remedy[256];      /**< what to do next, zero-terminated */
} carom_error;

/* clang-format off */
#define CAROM_ERROR_INIT { sizeof(carom_error), 0, 0, 0, {0, 0, 0}, {0, 0, 0}, {0}, {0} }
/* clang-format on */

/* ---- handles: 64 bits of kind, owner tag, generation, slot; 0 is never issued; validated on every call ---- */
typedef uint64_t carom_plugin;
typedef uint64_t carom_shape;
typedef uint64_t carom_material;
typedef uint64_t carom_body;
typedef uint64_t carom_collider;
typedef uint64_t carom_particles; /* a set of them */
typedef uint64_t carom_joint;
typedef uint64_t carom_force_field;
typedef uint64_t carom_spring;
#define CAROM_NULL_HANDLE ((uint64_t)0) /* no object: never the handle of one */

/* Numbers in the arrays of a host. */
#define CAROM_SCALAR_F32 0u /* float, 4 bytes */
#define CAROM_SCALAR_F64 1u /* double, 8 bytes */

/** Version of the library that is running (the CAROM_VERSION_* macros are the header's).
 *  @param major, minor, patch as CAROM_VERSION_*
 *  @status OK; NULL_ARGUMENT */
CAROM_API int32_t carom_version(uint32_t *major, uint32_t *minor, uint32_t *patch);

/** Name of a result code, e.g. "CAROM_E_BUSY"; "CAROM_E_?" for an unknown one. Static storage.
 *  @param result of any call */
CAROM_API const char *carom_result_name(int32_t result);

/** What to do about a result code, in one sentence. Static storage.
 *  @param result of any call */
CAROM_API const char *carom_result_remedy(int32_t result);

/** The layout of every struct of this interface, as the compiler that built this library has it: for a binding, which
 *  compares it with its own when it is loaded. Lines of four words, ending in '\n'; first "carom" and the version:
 *      carom 0.9.0
 *      carom_error 0 576 struct              name, offset, size in bytes, kind
 *      carom_error.struct_size 0 4 u32
 *      carom_error.witness_dir 16 24 f64[3]
 *  Kinds: u32, i32, u64 (handles too), f64, char, ptr, fn (pointer to a function), struct; [n] behind it: an array.
 *  Newer libraries have more lines, and a struct may be larger; a field stays as it is.
 *  Static storage. */
CAROM_API const char *carom_abi_manifest(void);

/** Is this library what a client was built for? As bindings ask when they have loaded it: of the same major version and
 *  not older (of the same minor version before 1.0), and with the same structs, some of which may be larger here.
 *  @param layout  of the client: lines of carom_abi_manifest(), the first with its version, zero-terminated
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (no line of a version); UNSUPPORTED (the message names this library's file, and the
 *          first line that differs) */
CAROM_API int32_t carom_abi_check(const char *layout, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
