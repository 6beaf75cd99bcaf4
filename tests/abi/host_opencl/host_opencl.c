/* OpenCL as far as src/abi/opencl.cpp uses it, on the processor itself: a program is compiled by the system's C compiler and
 * run pair by pair. So all that is done for a device is tested where there is none, and the text of devices as a host's
 * compiler takes it. Its manners are asked for in the environment, HOST_OPENCL:
 *   single    a device without double precision
 *   contract  a compiler that contracts a * b + c where the processor can
 *   fails     kernels that are refused
 *   none      no device
 *   quick     a compiler that does not optimise
 * A program's text is written to the file that HOST_OPENCL_TEXT names, as well. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define EXPORT __attribute__((visibility("default")))
enum { MOST_ARGUMENTS = 16 };

typedef struct {
  char *text, log[4096];
  void* code;
} Program;

typedef struct {
  size_t bytes;
  char data[];
} Buffer;

typedef struct {
  void (*run)(void);
  uint64_t* item;
  char name[64];
  size_t count, size[MOST_ARGUMENTS];
  uint64_t value[MOST_ARGUMENTS];
} Kernel;

static int is(const char* manner) {
  const char* const asked = getenv("HOST_OPENCL");
  return asked && strcmp(asked, manner) == 0;
}

EXPORT int32_t clGetPlatformIDs(uint32_t room, void** platforms, uint32_t* count) {
  static int platform;
  if (room && platforms) platforms[0] = &platform;
  if (count) *count = 1;
  return 0;
}
EXPORT int32_t clGetDeviceIDs(void* platform, uint64_t type, uint32_t room, void** devices, uint32_t* count) {
  static int device;
  (void)platform, (void)type;
  if (is("none")) return -1;
  if (room && devices) devices[0] = &device;
  if (count) *count = 1;
  return 0;
}
EXPORT int32_t clGetDeviceInfo(void* device, uint32_t which, size_t size, void* value, size_t* needed) {
  (void)device, (void)needed;
  if (which == 0x102B) return snprintf(value, size, "this processor"), 0;
  if (which == 0x102F) return snprintf(value, size, "OpenCL 1.2 by cc"), 0;
  if (size == 8) memcpy(value, &(uint64_t){is("single") ? 0 : 63}, 8);
  if (size == 4) memcpy(value, &(uint32_t){1}, 4);
  return 0;
}
EXPORT void* clCreateContext(const intptr_t* p, uint32_t n, void* const* devices, void* notify, void* user,
                             int32_t* code) {
  (void)p, (void)n, (void)notify, (void)user;
  *code = 0;
  return devices[0];
}
EXPORT int32_t clReleaseContext(void* context) { return (void)context, 0; }
EXPORT void* clCreateCommandQueue(void* context, void* device, uint64_t properties, int32_t* code) {
  (void)device, (void)properties;
  *code = 0;
  return context;
}
EXPORT int32_t clReleaseCommandQueue(void* queue) { return (void)queue, 0; }

EXPORT void* clCreateBuffer(void* context, uint64_t flags, size_t bytes, void* host, int32_t* code) {
  Buffer* const b = malloc(sizeof(Buffer) + bytes);
  (void)context, (void)flags, (void)host;
  *code = b ? 0 : -4;
  if (b) b->bytes = bytes, memset(b->data, 0x55, bytes);
  return b;
}
EXPORT int32_t clReleaseMemObject(void* buffer) { return free(buffer), 0; }
EXPORT int32_t clEnqueueWriteBuffer(void* queue, void* buffer, uint32_t wait, size_t at, size_t bytes, const void* data,
                                    uint32_t events, void* list, void* event) {
  Buffer* const b = buffer;
  (void)queue, (void)wait, (void)events, (void)list, (void)event;
  if (at + bytes > b->bytes) return -30;
  return memcpy(b->data + at, data, bytes), 0;
}
EXPORT int32_t clEnqueueReadBuffer(void* queue, void* buffer, uint32_t wait, size_t at, size_t bytes, void* data,
                                   uint32_t events, void* list, void* event) {
  const Buffer* const b = buffer;
  (void)queue, (void)wait, (void)events, (void)list, (void)event;
  if (at + bytes > b->bytes) return -30;
  return memcpy(data, b->data + at, bytes), 0;
}

EXPORT void* clCreateProgramWithSource(void* context, uint32_t n, const char** texts, const size_t* sizes,
                                       int32_t* code) {
  Program* const p = calloc(1, sizeof *p);
  (void)context, (void)n, (void)sizes;
  p->text = strdup(texts[0]);
  *code = 0;
  return p;
}
EXPORT int32_t clReleaseProgram(void* program) {
  Program* const p = program;
  if (p->code) dlclose(p->code);
  free(p->text);
  return free(p), 0;
}
EXPORT int32_t clBuildProgram(void* program, uint32_t n, void* const* devices, const char* options, void* notify,
                              void* user) {
  Program* const p = program;
  char folder[] = "/tmp/host_opencl_XXXXXX", path[64], command[512];
  FILE* file;
  (void)n, (void)devices, (void)options, (void)notify, (void)user;
  if (!mkdtemp(folder)) return -6;
  snprintf(path, sizeof path, "%s/p.c", folder);
  file = fopen(path, "w");
  fprintf(file, "%s\nuint64_t* host_opencl_item(void) { return &carom_item; }\n", p->text);
  fclose(file);
  if (getenv("HOST_OPENCL_TEXT") && (file = fopen(getenv("HOST_OPENCL_TEXT"), "w")))
    fprintf(file, "%s", p->text), fclose(file);
  snprintf(command, sizeof command,
           "cc -std=c99 %s -fPIC -shared -Wall -Wextra -Werror=implicit-function-declaration %s -o %s/p.so %s -lm 2>&1",
           is("quick") ? "-O0" : "-O2", is("contract") ? "-ffp-contract=fast -march=native" : "-ffp-contract=off",
           folder, path);
  file = popen(command, "r");
  p->log[fread(p->log, 1, sizeof p->log - 1, file)] = 0;
  if (pclose(file) == 0) {
    snprintf(path, sizeof path, "%s/p.so", folder);
    p->code = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  }
  snprintf(command, sizeof command, "rm -r %s", folder);
  if (system(command)) return -6;
  return p->code ? 0 : -11;
}
EXPORT int32_t clGetProgramBuildInfo(void* program, void* device, uint32_t which, size_t size, void* value,
                                     size_t* needed) {
  const Program* const p = program;
  (void)device, (void)which;
  if (needed) *needed = strlen(p->log) + 1;
  if (value) snprintf(value, size, "%s", p->log);
  return 0;
}

EXPORT void* clCreateKernel(void* program, const char* name, int32_t* code) {
  const Program* const p = program;
  Kernel* const k = calloc(1, sizeof *k);
  uint64_t* (*item)(void);
  *(void**)&k->run = dlsym(p->code, name);
  *(void**)&item = dlsym(p->code, "host_opencl_item");
  k->item = item();
  snprintf(k->name, sizeof k->name, "%s", name);
  *code = k->run ? 0 : -46;
  return k;
}
EXPORT int32_t clReleaseKernel(void* kernel) { return free(kernel), 0; }
EXPORT int32_t clSetKernelArg(void* kernel, uint32_t i, size_t size, const void* value) {
  Kernel* const k = kernel;
  if (i >= MOST_ARGUMENTS || size > 8) return -49;
  k->size[i] = size, k->value[i] = 0;
  memcpy(&k->value[i], value, size);
  return 0;
}
static const void* at(const Kernel* k, int i) { return ((const Buffer*)(uintptr_t)k->value[i])->data; }
static double real(const Kernel* k, int i) {
  double x;
  return memcpy(&x, &k->value[i], 8), x;
}
EXPORT int32_t clEnqueueNDRangeKernel(void* queue, void* kernel, uint32_t dimensions, const size_t* offset,
                                      const size_t* count, const size_t* local, uint32_t events, void* list,
                                      void* event) {
  const Kernel* const k = kernel;
  (void)queue, (void)dimensions, (void)offset, (void)local, (void)events, (void)list, (void)event;
  if (is("fails") && strcmp(k->name, "carom_measure_pairs") == 0) return -36;
  for (uint64_t i = 0; i < *count; ++i) {
    *k->item = i;
    if (strcmp(k->name, "carom_measure_pairs") == 0)
      ((void (*)(const void*, const void*, const void*, const void*, const void*, const void*, double, double, uint32_t,
                 uint32_t, uint32_t, const void*))k->run)(at(k, 0), at(k, 1), at(k, 2), at(k, 3), at(k, 4), at(k, 5),
                                                          real(k, 6), real(k, 7), (uint32_t)k->value[8],
                                                          (uint32_t)k->value[9], (uint32_t)k->value[10], at(k, 11));
    else if (strcmp(k->name, "carom_ask_directions") == 0)
      ((void (*)(uint32_t, const void*, uint64_t, uint64_t, const void*, uint32_t, const void*))k->run)(
          (uint32_t)k->value[0], at(k, 1), k->value[2], k->value[3], at(k, 4), (uint32_t)k->value[5], at(k, 6));
    else
      ((void (*)(const void*, uint32_t, const void*))k->run)(at(k, 0), (uint32_t)k->value[1], at(k, 2));
  }
  return 0;
}
EXPORT int32_t clFinish(void* queue) { return (void)queue, 0; }
