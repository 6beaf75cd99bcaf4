/* The part of CMocka that tests/determinism uses, for a target that Debian has no CMocka for. The first assertion that
 * fails ends the program. */
#ifndef CAROM_WASM_CMOCKA_H
#define CAROM_WASM_CMOCKA_H

#include <stdio.h>
#include <stdlib.h>

struct CMUnitTest {
  const char* name;
  void (*run)(void** state);
};
#define cmocka_unit_test(f) \
  { #f, f }
#define print_error(...) fprintf(stderr, __VA_ARGS__)
#define assert_true(c) carom_assert((c) != 0, #c, __FILE__, __LINE__)
#define assert_int_equal(a, b) carom_assert((a) == (b), #a " == " #b, __FILE__, __LINE__)

static inline void carom_assert(int holds, const char* what, const char* file, int line) {
  if (holds) return;
  fprintf(stderr, "%s:%d: not so: %s\n", file, line, what);
  exit(1);
}

#define cmocka_run_group_tests_name(group, tests, setup, teardown) \
  carom_run_tests(group, tests, sizeof(tests) / sizeof((tests)[0]))

static inline int carom_run_tests(const char* group, const struct CMUnitTest* tests, size_t n) {
  size_t i;
  for (i = 0; i < n; ++i) {
    void* state = NULL;
    tests[i].run(&state);
    printf("%s: %s\n", group, tests[i].name);
  }
  return 0;
}

#endif
