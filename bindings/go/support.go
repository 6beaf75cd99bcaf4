package carom

/*
#cgo pkg-config: carom
#include <carom/carom.h>
#include <stdlib.h>

int32_t caromSupport(void *, double *, uint64_t, double *, double *); // Go's, below: it has no const
static void *carom_support(void) { return (void *)caromSupport; }
*/
import "C"

import (
	"runtime/cgo"
	"unsafe"

	"carom/raw"
)

// Param is a parameter of a kind of shape: a value outside [Min, Max] is refused when a shape is made.
type Param struct {
	Name, Unit string // Unit: "m", or "1" of a number without a dimension
	Min, Max   float64
}

// Support gives the farthest point of a shape along a direction; carom_support_fn says what it must keep to. A panic in it is a
// fault of the shape.
type Support func(params []float64, direction Vec3) Vec3

// What C has pointers to as long as the engine lives.
type kept struct {
	handle cgo.Handle
	memory []unsafe.Pointer
}

func (k *kept) allocate(size uintptr) unsafe.Pointer {
	k.memory = append(k.memory, C.calloc(1, C.size_t(size)))
	return k.memory[len(k.memory)-1]
}

func (k *kept) text(text string) unsafe.Pointer {
	k.memory = append(k.memory, unsafe.Pointer(C.CString(text)))
	return k.memory[len(k.memory)-1]
}

func (k *kept) free() {
	for _, pointer := range k.memory {
		C.free(pointer)
	}
	k.handle.Delete()
}

// Plugin makes a kind of shape whose support function is Go, for ShapeOf. It is called on the thread that makes the call. It lives
// as long as the engine.
func (engine *Engine) Plugin(id string, params []Param, support Support) (plugin Plugin, err error) {
	k := kept{handle: cgo.NewHandle(support)}
	user := k.allocate(unsafe.Sizeof(k.handle))
	*(*cgo.Handle)(user) = k.handle
	table := unsafe.Slice((*raw.Param)(k.allocate(unsafe.Sizeof(raw.Param{})*uintptr(len(params)+1))), len(params))
	for i, p := range params {
		table[i] = raw.Param{Name: (*byte)(k.text(p.Name)), Unit: (*byte)(k.text(p.Unit)), Min: p.Min, Max: p.Max}
	}
	description := (*raw.ShapePlugin)(k.allocate(unsafe.Sizeof(raw.ShapePlugin{})))
	*description = raw.NewShapePlugin()
	description.AbiMajor, description.AbiMinor = raw.CAROM_PLUGIN_ABI_MAJOR, raw.CAROM_PLUGIN_ABI_MINOR
	description.Flags = raw.CAROM_PLUGIN_HOST_THREAD
	description.Id, description.Version = (*byte)(k.text(id)), 1
	description.Params, description.ParamCount = unsafe.SliceData(table), uint32(len(params))
	description.Support, description.User = C.carom_support(), user
	engine.lock.Lock()
	engine.kept = append(engine.kept, k)
	engine.lock.Unlock()
	err = engine.Call(func(p *raw.Engine, e *raw.Error) int32 { return raw.PluginRegister(p, description, &plugin, e) })
	return
}

//export caromSupport
func caromSupport(user unsafe.Pointer, params *C.double, n C.uint64_t, direction, out *C.double) (result C.int32_t) {
	defer func() {
		if recover() != nil {
			result = 1
		}
	}()
	support := (*(*cgo.Handle)(user)).Value().(Support)
	*(*Vec3)(unsafe.Pointer(out)) = support(unsafe.Slice((*float64)(params), int(n)), *(*Vec3)(unsafe.Pointer(direction)))
	return 0
}
