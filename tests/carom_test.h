// CMocka for C and C++ tests. Its macros (fail, ...) collide with the standard library's headers, so include this LAST.
#pragma once

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#include <cmocka.h>
#ifdef __cplusplus
}
#endif
#undef fail
