// Version, result names and remedies: the one list that every status comes from.
#include <carom/base.h>

namespace {

struct ResultRow {
  int32_t code;
  const char* name;
  const char* remedy;
};

#define ROW(code, remedy) \
  { code, #code, remedy }
constexpr ResultRow kResults[] = {
    ROW(CAROM_OK, "nothing to do"),
    ROW(CAROM_E_NULL_ARGUMENT, "pass a pointer where the header does not say NULL is allowed"),
    ROW(CAROM_E_NOT_FINITE, "pass finite numbers; look for a division by zero or an uninitialised value on your side"),
    ROW(CAROM_E_OUT_OF_RANGE, "pass a value within the bounds that the message names"),
    ROW(CAROM_E_NOT_UNIT, "normalise the quaternion or normal to within 1e-6 of unit length"),
    ROW(CAROM_E_UNKNOWN_ENUM, "use a constant of the header this library was built with; see carom_version()"),
    ROW(CAROM_E_STRUCT_SIZE, "set struct_size to the sizeof of the struct, or call its *_init function if it has one"),
    ROW(CAROM_E_UNSUPPORTED,
        "do without what the message names; of fields and bits that the library does not know, leave them zero or use a newer library"),
    ROW(CAROM_E_INVALID_HANDLE, "pass a handle that a create call returned"),
    ROW(CAROM_E_STALE_HANDLE, "drop this handle; its object was destroyed"),
    ROW(CAROM_E_WRONG_KIND, "pass a handle of the kind that the header names for this argument"),
    ROW(CAROM_E_WRONG_WORLD,
        "pass the world or engine that returned the handle; if that was destroyed, drop the handle"),
    ROW(CAROM_E_BUSY,
        "wait until the other thread's call on this world has returned, or guard the world with a lock of your own"),
    ROW(CAROM_E_REENTRANT, "do not call carom_* from a support function, allocator or log; do it after the step"),
    ROW(CAROM_E_IN_USE, "destroy what refers to it first"),
    ROW(CAROM_E_OUT_OF_MEMORY, "free memory or raise the allocator's limit, then call again"),
    ROW(CAROM_E_LIMIT, "destroy what is no longer needed, or spread the scene over several worlds"),
    ROW(CAROM_E_BUFFER_TOO_SMALL,
        "pass at least the size that the message names: a buffer's, or the sizeof of an element as a stride"),
    ROW(CAROM_E_PLUGIN_PATH, "pass the absolute path of a readable shared object"),
    ROW(CAROM_E_PLUGIN_LOAD,
        "build a shared object for this machine that exports `const carom_shape_plugin carom_shape_plugin_v1` and links what it needs"),
    ROW(CAROM_E_PLUGIN_ABI, "rebuild the plugin against this library's carom/plugin.h"),
    ROW(CAROM_E_PLUGIN_INVALID, "make support return the farthest point of one bounded convex set; try `carom check`"),
    ROW(CAROM_E_DECLARATION_FALSE, "correct or drop the declaration in the plugin's carom_geometry"),
    ROW(CAROM_E_NO_VOLUME, "give the body a mass and inertia, or the collider density 0"),
    ROW(CAROM_E_ALREADY_EXISTS, "use carom_plugin_find() to get the one that is loaded"),
    ROW(CAROM_E_NOT_FOUND, "check the spelling of what the message names"),
    ROW(CAROM_E_INTERNAL, "report this with the calls that led to it"),
    ROW(CAROM_E_CORRUPT, "take the bytes again from where they were saved, all of them and unchanged"),
    ROW(CAROM_E_MISMATCH,
        "restore into a world that was made by the same calls as the one that was saved, or save it whole and restore into a new one"),
    ROW(CAROM_E_WRITE_FAILED, "see that what the write function writes to has space, and record anew"),
    ROW(CAROM_E_READ_ONLY, "leave it: this number is fixed, carom_constant_get_info() says why; set a dial instead"),
};
#undef ROW

}  // namespace

extern "C" {

int32_t carom_version(uint32_t* major, uint32_t* minor, uint32_t* patch) {
  if (!major || !minor || !patch) return CAROM_E_NULL_ARGUMENT;
  *major = CAROM_VERSION_MAJOR;
  *minor = CAROM_VERSION_MINOR;
  *patch = CAROM_VERSION_PATCH;
  return CAROM_OK;
}

const char* carom_result_name(int32_t result) {
  for (const ResultRow& row : kResults)
    if (row.code == result) return row.name;
  return "CAROM_E_?";
}

const char* carom_result_remedy(int32_t result) {
  for (const ResultRow& row : kResults)
    if (row.code == result) return row.remedy;
  return "use a result that a carom_* call returned";
}

}  // extern "C"
