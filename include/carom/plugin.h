/** @file plugin.h
 *  All that the author of a shape needs. A shape plugin is a shared object (or a struct registered by pointer) that
 *  exports ONE const data symbol, carom_shape_plugin_v1, and whose only code is a support function.
 *  It links nothing of Carom. Copy plugins/template and change one function.
 */
#ifndef CAROM_PLUGIN_H
#define CAROM_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_PLUGIN_ABI_MAJOR 1u /* a plugin with another one is refused */
#define CAROM_PLUGIN_ABI_MINOR 0u /* grows with additions */

/** Support function of a bounded convex set: the point of the set farthest along dir, in the shape's own frame.
 *  Contract: pure (same bits in, same bits out), callable from several threads at once; dir is finite and nonzero, of a
 *  length of 5e-324 to 1e308: divide it by its largest component before multiplying or squaring it; ties may be broken
 *  either way, but repeatably; no allocation, lock, I/O, change of the floating-point environment, or carom_* call.
 *  @param user       as the plugin has it: state of a host's function; NULL for a file's
 *  @param params     [param_len] the shape's parameters; owned by the engine, immutable
 *  @param param_len  number of parameters
 *  @param dir        [3] direction, shape frame, any positive length
 *  @param out        [3] m, shape frame: argmax over x in the set of dir . x
 *  @return 0; anything else reports a fault: the pair is skipped and the shape put in quarantine */
typedef int32_t (*carom_support_fn)(void *user, const double *params, uint64_t param_len, const double dir[3],
                                    double out[3]);

#if defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L) /* C90 has no macros of this kind */
/** The parameters as a support function sees them. On a device (pairs.h) they lie in another memory than the stack, so
 *  a text says carom_params where it could say const double *. */
typedef const double *carom_params;

/** The support function as code and, word by word, as text, so that a device can be given it:
 *      CAROM_SUPPORT_TEXT(
 *      static int32_t support(void *user, carom_params params, uint64_t n, const double dir[3], double out[3]) { ... }
 *      )
 *  defines the function and `static const char support_text[]`, for carom_shape_plugin.text. Within it stands all that
 *  the function uses: functions beside it, enumerations, constants. It is C99 without lines that begin with #, macros,
 *  strings, float and long. Of the C library it calls sqrt() and fabs() alone, which round alike everywhere. It does
 *  not read `user`. A text is believed where it gives the bits of the function that was loaded, in 256 directions of
 *  each shape. */
#define CAROM_SUPPORT_TEXT(...) __VA_ARGS__ static const char support_text[] = #__VA_ARGS__;
#endif

/** Documentation and bounds of one parameter; a value outside [min, max] is refused when a shape is made. */
typedef struct carom_param {
  const char *name; /**< "radius" */
  const char *unit; /**< "m"; "1" of a number without a dimension. Never empty */
  double min;       /**< smallest legal value, inclusive */
  double max;       /**< largest legal value, inclusive */
} carom_param;

/** What several parameters fulfil together: the sum of weight[i] * params[param[i]] over its terms is at most `most`.
 *  Parameters that do not are refused when a shape is made (OUT_OF_RANGE, with `text`), and the plugin is not judged by
 *  them. A lens that is thinner than its radius: {"height <= 0.99 radius", 2, {1, 0}, {1, -0.99}, 0}. */
typedef struct carom_param_rule {
  const char *text;    /**< for people: "height <= 0.99 radius" */
  uint32_t term_count; /**< 1 to 4 */
  uint32_t param[4];   /**< [term_count] indices into params; of a tail, its first group */
  double weight[4];    /**< [term_count] finite */
  double most;         /**< finite */
} carom_param_rule;

/* Closed forms that an engine may know a faster or exact routine for. arg[i] below are indices into params. */
/* clang-format off */
#define CAROM_FORM_NONE 0u      /* nothing declared */
#define CAROM_FORM_SPHERE 1u    /* centre at the origin; arg[0]: radius */
#define CAROM_FORM_CAPSULE 2u   /* axis y; arg[0]: radius, arg[1]: half height of the core segment */
#define CAROM_FORM_BOX 3u       /* centred, axis-aligned; arg[0..2]: half extents x, y, z */
#define CAROM_FORM_POLYTOPE 4u  /* hull of points; arg[0]: index of the first coordinate; the rest of params are x,y,z
                                   triples */
#define CAROM_FORM_CYLINDER 5u  /* axis y, centred; arg[0]: radius, arg[1]: half height */
#define CAROM_FORM_CONE 6u      /* axis y, apex at +half height, base disc at -half height; arg[0]: base radius,
                                   arg[1]: half height */
#define CAROM_FORM_ELLIPSOID 7u /* centred, axis-aligned; arg[0..2]: radii x, y, z */
/* clang-format on */

/** In place of an index into params: no parameter. A geometry must write it for core_radius_param where there is no
 *  core radius, since 0 there is the first parameter. In form_arg and mass_arg it marks places that the form does not
 *  use; those are not read, so 0 does as well. Where the form needs an index, it is refused (PLUGIN_ABI). */
#define CAROM_NO_PARAM 0xFFFFFFFFu

/** What the author knows beyond the support function. Data, not code; verified against the support function when a
 *  shape is made (a false declaration is refused with a witness direction); never trusted. */
typedef struct carom_geometry {
  uint32_t struct_size;       /**< sizeof(carom_geometry) */
  uint32_t form;              /**< CAROM_FORM_*: the whole set, core radius included, equals this closed form */
  uint32_t form_arg[4];       /**< indices into params, as many as the form uses (see CAROM_FORM_*); CAROM_NO_PARAM in
                                   the others */
  uint32_t core_radius_param; /**< index into params of the core radius, or CAROM_NO_PARAM: no core radius. With an
                                   index, the support function is that of the CORE, and the shape is the core
                                   swollen by that radius (a sphere is a point with a radius, a capsule a segment) */
  uint32_t mass_form;   /**< CAROM_FORM_*: the shape has its volume, centre and inertia; NONE: derive from support */
  uint32_t mass_arg[4]; /**< indices into params for mass_form */
} carom_geometry;

#define CAROM_PLUGIN_HOST_THREAD 1u /* flags: support may only be called on the thread that steps (scripting hosts) */

/** The plugin. Export it as
 *      const carom_shape_plugin carom_shape_plugin_v1 = { ... };
 *  or pass it to carom_plugin_register(). Everything it points to must live as long as the engine. */
typedef struct carom_shape_plugin {
  uint32_t struct_size;           /**< sizeof(carom_shape_plugin) */
  uint32_t abi_major;             /**< CAROM_PLUGIN_ABI_MAJOR */
  uint32_t abi_minor;             /**< CAROM_PLUGIN_ABI_MINOR */
  uint32_t flags;                 /**< CAROM_PLUGIN_HOST_THREAD or 0 */
  const char *id;                 /**< unique, reverse-domain or short: "carom.sphere" */
  uint32_t version;               /**< of the shape's meaning: raise it when the same params give another set */
  uint32_t param_count;           /**< number of entries in params; the parameters every shape of this kind has */
  const carom_param *params;      /**< [param_count] */
  const carom_geometry *geometry; /**< optional declarations, or NULL */
  carom_support_fn support;       /**< the only code */
  uint32_t param_tail_group;      /**< 0: exactly param_count parameters. k > 0: the last k entries repeat, so a shape
                                      has param_count + m*k parameters, m >= 0 (hull: x, y, z repeated) */
  uint32_t param_tail_min;        /**< smallest number of groups in all, the declared one included (hull: 1) */
  const carom_param_rule *rules;  /**< [rule_count] or NULL */
  uint32_t rule_count;            /**< at most 64 */
  uint32_t reserved;              /**< 0 */
  /** handed to support: what a closure of the host holds, or NULL. The function must stay pure: same point for
   *  the same user, params and dir, as long as the plugin is there */
  void *user;
  const char *text; /**< `support_text` of CAROM_SUPPORT_TEXT(), zero-terminated; NULL: devices cannot ask the shape */
} carom_shape_plugin;

/** The symbol looked up in a shared object. */
#define CAROM_SHAPE_PLUGIN_SYMBOL "carom_shape_plugin_v1"

#if defined(_WIN32)
#define CAROM_PLUGIN_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define CAROM_PLUGIN_EXPORT __attribute__((visibility("default")))
#else
#define CAROM_PLUGIN_EXPORT
#endif
extern CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1;

#ifdef __cplusplus
}
#endif
#endif
