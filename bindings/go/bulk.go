package carom

import (
	"fmt"
	"reflect"
	"unsafe"

	"carom/raw"
)

// Pose is a record of raw.CAROM_FIELD_POSE.
type Pose struct {
	Position    Vec3
	Orientation Quat
}

// Record is what one body has of a field: as many numbers as the field, or more.
type Record interface {
	[1]float64 | [3]float64 | [4]float64 | [6]float64 | [7]float64 | Pose |
		[1]float32 | [3]float32 | [4]float32 | [6]float32 | [7]float32
}

// Read copies a field, raw.CAROM_FIELD_*, of some bodies, or, where of is nil, of all in the order of World.Bodies.
func Read[R Record](world *World, field uint32, of []Body, dst []R) error {
	return transfer(of, dst, func(scalar uint32, bodies *Body, n uint64, stride uint64, e *raw.Error) int32 {
		return raw.WorldRead(world.pointer, field, scalar, bodies, n, unsafe.Pointer(unsafe.SliceData(dst)), stride, e)
	})
}

// Write sets a field as Read reads it; all values are validated before the first is written.
func Write[R Record](world *World, field uint32, of []Body, src []R) error {
	return transfer(of, src, func(scalar uint32, bodies *Body, n uint64, stride uint64, e *raw.Error) int32 {
		return raw.WorldWrite(world.pointer, field, scalar, bodies, n, unsafe.Pointer(unsafe.SliceData(src)), stride, e)
	})
}

// Positions reads those of all bodies, in the order of Bodies.
func (world *World) Positions(dst []Vec3) error {
	return Read(world, raw.CAROM_FIELD_POSITION, nil, dst)
}

// Poses reads those of all bodies, in the order of Bodies.
func (world *World) Poses(dst []Pose) error { return Read(world, raw.CAROM_FIELD_POSE, nil, dst) }

func transfer[R Record](of []Body, records []R, call func(scalar uint32, bodies *Body, n, stride uint64, e *raw.Error) int32) error {
	var record R
	if of != nil && len(of) != len(records) {
		return &Error{Code: Code(raw.CAROM_E_OUT_OF_RANGE), Message: fmt.Sprintf("%d records for %d bodies", len(records), len(of)),
			Remedy: "pass as many records as bodies"}
	}
	scalar := raw.CAROM_SCALAR_F64
	if kind := reflect.TypeOf(record); kind.Kind() == reflect.Array && kind.Elem().Kind() == reflect.Float32 {
		scalar = raw.CAROM_SCALAR_F32
	}
	return check(func(e *raw.Error) int32 {
		return call(scalar, unsafe.SliceData(of), uint64(len(records)), uint64(unsafe.Sizeof(record)), e)
	})
}

// All of a list that says how many there are: asked for none first, then for all.
func list[T any](ask func(dst *T, capacity uint64, count *uint64, e *raw.Error) int32) ([]T, error) {
	var all []T
	var count uint64
	for {
		err := check(func(e *raw.Error) int32 { return ask(unsafe.SliceData(all), uint64(len(all)), &count, e) })
		if err != nil || count <= uint64(len(all)) {
			return all[:min(count, uint64(len(all)))], err
		}
		all = make([]T, count)
	}
}
