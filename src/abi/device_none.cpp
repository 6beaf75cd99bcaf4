// Devices where the library loads no shared objects, and so no OpenCL: there is none, and each call says so.
#include <carom/pairs.h>

#include "abi/check.h"
#include "abi/guard.h"

using namespace carom::abi;

namespace {

bool fail(Call& call) {
  return call.fail(CAROM_E_NOT_FOUND, 0, "there is no OpenCL to load: this library loads no shared objects") ||
         call.advise("ask on the host: carom_pairs_distance()");
}

int32_t of_none(const carom_device* device, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (present(call, 1, "device", device)) fail(call);
  });
}

}  // namespace

extern "C" {

int32_t carom_device_create(carom_engine* engine, uint32_t, carom_device** device, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (present(call, 1, "engine", engine) && present(call, 3, "device", device)) fail(call);
  });
}

int32_t carom_device_destroy(carom_device* device, carom_error* error) { return of_none(device, error); }

int32_t carom_device_get_info(carom_device* device, carom_device_info*, carom_error* error) {
  return of_none(device, error);
}

int32_t carom_device_pairs_distance(carom_device* device, const carom_pairs*, const carom_distance_desc*,
                                    carom_distance*, uint64_t, carom_error* error) {
  return of_none(device, error);
}

}  // extern "C"
