// A device of this machine, by whatever OpenCL is installed (Debian: ocl-icd-libopencl1, pocl-opencl-icd): the bits are the
// host's. Skipped where there is none.
#include "device_checks.h"

namespace {

using namespace device_checks;

void the_bits_are_the_hosts(void**) {
#if defined(CAROM_SANITIZED)
  std::printf("skipped: drivers' compilers do not run under a sanitizer; test_device_on_host.cpp does\n");
  skip();
#endif
  carom_engine* engine = engine_of(2);
  carom_error why;
  carom_device* device = device_of(engine, why);
  if (!device) {
    std::printf("skipped: %s. %s\n", why.message, why.remedy);
    assert_true(why.code == CAROM_E_NOT_FOUND || why.code == CAROM_E_UNSUPPORTED);
    assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
    skip();
  }
  check_bits(engine, device, 100000);
  close(engine, device);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(the_bits_are_the_hosts)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
