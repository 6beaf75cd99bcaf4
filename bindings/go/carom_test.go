package carom

import (
	"errors"
	"math"
	"strings"
	"sync"
	"testing"

	"carom/raw"
)

func must[T any](value T, err error) T {
	if err != nil {
		panic(err)
	}
	return value
}

func ok(t *testing.T, err error) {
	t.Helper()
	if err != nil {
		t.Fatal(err)
	}
}

func fails(t *testing.T, err error, code int32) *Error {
	t.Helper()
	var e *Error
	if !errors.As(err, &e) || !errors.Is(err, Code(code)) || !strings.Contains(err.Error(), ". Remedy: ") {
		t.Fatalf("%v is not %v with a remedy", err, Code(code))
	}
	return e
}

func setUp(t *testing.T) (*Engine, *World) {
	engine := must(NewEngine(1))
	world := must(engine.World())
	t.Cleanup(func() { ok(t, world.Close()); ok(t, engine.Close()) })
	return engine, world
}

func TestFailuresHaveARemedy(t *testing.T) {
	engine, world := setUp(t)
	_, err := engine.Shape("no_such_shape")
	fails(t, err, raw.CAROM_E_NOT_FOUND)
	_, err = engine.Shape("sphere", -1)
	fails(t, err, raw.CAROM_E_OUT_OF_RANGE)
	if e := fails(t, world.Step(2), raw.CAROM_E_OUT_OF_RANGE); e.Argument != 2 {
		t.Fatal(e.Argument)
	}
	ball := must(world.Body(must(engine.Shape("sphere", 0.5)), Vec3{}))
	ok(t, world.Destroy(ball))
	_, err = world.Position(ball)
	fails(t, err, raw.CAROM_E_STALE_HANDLE)
	_, err = world.Body(0, Vec3{})
	fails(t, err, raw.CAROM_E_INVALID_HANDLE)
	if len(must(world.Bodies())) != 0 {
		t.Fatal("the body without its collider is still there")
	}
	_, err = engine.Plugin("test.panics", nil, func([]float64, Vec3) Vec3 { panic("no") })
	fails(t, err, raw.CAROM_E_PLUGIN_INVALID)
	_, err = engine.Plugin("test.dent", nil, func(_ []float64, d Vec3) Vec3 { return Vec3{-d[0], d[1], d[2]} })
	if fails(t, err, raw.CAROM_E_PLUGIN_INVALID).Witness == nil {
		t.Fatal("no witness")
	}
	fails(t, engine.Close(), raw.CAROM_E_IN_USE)
	closed := must(engine.World())
	ok(t, closed.Close())
	ok(t, closed.Close())
	fails(t, closed.Step(0.01), raw.CAROM_E_NULL_ARGUMENT)
}

func TestArraysOfBodies(t *testing.T) {
	engine, world := setUp(t)
	shape := must(engine.Shape("sphere", 0.5))
	var made []Body
	for i := range 100 {
		made = append(made, must(world.Body(shape, Vec3{2 * float64(i), 1, 0})))
	}
	positions, poses, floats := make([]Vec3, 100), make([]Pose, 100), make([][3]float32, 100)
	ok(t, world.Positions(positions))
	ok(t, world.Poses(poses))
	ok(t, Read(world, raw.CAROM_FIELD_POSITION, nil, floats))
	for i, body := range must(world.Bodies()) {
		if body != made[i] || positions[i] != must(world.Position(body)) ||
			poses[i].Position != positions[i] || poses[i].Orientation != must(orientation(world, body)) || floats[i][0] != 2*float32(i) {
			t.Fatal(i, positions[i], poses[i], floats[i])
		}
	}
	ok(t, Write(world, raw.CAROM_FIELD_POSITION, made[:1], []Vec3{{0, 9, 0}}))
	if must(world.Position(made[0])) != (Vec3{0, 9, 0}) {
		t.Fatal("not written")
	}
	fails(t, world.Positions(positions[:99]), raw.CAROM_E_OUT_OF_RANGE)
	fails(t, Read(world, raw.CAROM_FIELD_POSITION, made[:2], positions), raw.CAROM_E_OUT_OF_RANGE)
	fails(t, Read(world, raw.CAROM_FIELD_POSITION, nil, make([][1]float64, 100)), raw.CAROM_E_BUFFER_TOO_SMALL)
}

func TestEveryKindOfArgument(t *testing.T) {
	engine, world := setUp(t)
	small := must(engine.Shape("sphere", 0.2))
	parts, places, turns := []Shape{small, small}, []Vec3{{-0.5, 0, 0}, {0.5, 0, 0}}, []Quat{{0, 0, 0, 1}}
	capsule := must(engine.ShapeCreateHullOf(parts, places, nil, nil, 0))
	_, err := engine.ShapeCreateHullOf(parts, nil, turns, nil, 0)
	fails(t, err, raw.CAROM_E_OUT_OF_RANGE)
	farthest := make([]Vec3, 2)
	ok(t, engine.ShapeSupport(capsule, []Vec3{{1, 0, 0}, {0, 2, 0}}, farthest))
	if math.Abs(farthest[0][0]-0.7) > 1e-12 || math.Abs(farthest[1][1]-0.2) > 1e-12 {
		t.Fatal(farthest)
	}
	fails(t, engine.ShapeSupport(capsule, places[:1], farthest), raw.CAROM_E_OUT_OF_RANGE)
	body := must(world.Body(capsule, Vec3{0, 2, 0}))
	_, before, _, err := world.Mass(body)
	ok(t, err)
	ok(t, world.SetMass(body, 3, nil, &[9]float64{1, 0, 0, 0, 2, 0, 0, 0, 2.5}))
	mass, center, inertia, err := world.Mass(body)
	ok(t, err)
	if mass != 3 || center != before || inertia[4] != 2 || inertia[8] != 2.5 {
		t.Fatal(mass, center, inertia)
	}
	hit := must(world.CastRay(Vec3{0, 5, 0}, Vec3{0, -1, 0}, 10, nil))
	if hit.Body != body || math.Abs(hit.Time-2.8) > 1e-6 {
		t.Fatal(hit)
	}
	asked := raw.NewAccuracy()
	asked.Place, asked.Turn = 1e-3, 1e-3
	ok(t, world.SetAccuracy(&asked))
	_, present, err := world.Accuracy()
	ok(t, err)
	ok(t, world.SetAccuracy(nil))
	_, absent, err := world.Accuracy()
	ok(t, err)
	if present != 1 || absent != 0 || len(must(world.Colliders(body))) != 1 {
		t.Fatal(present, absent)
	}
	same := make([]uint64, 1)
	ok(t, world.TranslateHandles([]uint64{uint64(body)}, same))
	if same[0] != uint64(body) {
		t.Fatal(same)
	}
}

func orientation(world *World, body Body) (Quat, error) {
	_, orientation, err := world.Pose(body)
	return orientation, err
}

func run(world *World) uint64 {
	for range 30 {
		if err := world.Step(1.0 / 60); err != nil {
			panic(err)
		}
	}
	return must(world.Hash())
}

func TestACopyAndSavedBytesGoOnAlike(t *testing.T) {
	engine, world := setUp(t)
	must(world.Ground(0))
	body := must(world.Body(must(engine.Shape("box", 0.5, 0.5, 0.5)), Vec3{0, 0.7, 0}))
	ok(t, world.SetVelocity(body, Vec3{}, Vec3{1, 2, 3}))
	saved := must(world.Save(raw.CAROM_SNAPSHOT_STATE))
	copy := must(world.Fork())
	defer copy.Close()
	after := run(world)
	if len(must(world.Contacts())) == 0 || run(copy) != after {
		t.Fatal("the copy went on otherwise")
	}
	ok(t, world.Restore(saved))
	if run(world) != after {
		t.Fatal("what was restored went on otherwise")
	}
	fails(t, world.Restore([]byte("nonsense")), raw.CAROM_E_CORRUPT)
}

func TestWorldsStepOnManyGoroutines(t *testing.T) {
	engine, _ := setUp(t)
	half := []Param{{"half", "m", 1e-6, 1e3}}
	box := must(engine.Plugin("test.box", half, func(p []float64, d Vec3) Vec3 {
		grow := make([]byte, 1<<16) // a stack that moves while C waits
		_ = grow[len(p)]
		return Vec3{math.Copysign(p[0], d[0]), math.Copysign(p[0], d[1]), math.Copysign(p[0], d[2])}
	}))
	hashes := make([]uint64, 4)
	var group sync.WaitGroup
	for i := range hashes {
		group.Add(1)
		go func() {
			defer group.Done()
			world := must(engine.World())
			must(world.Ground(0))
			must(world.Body(must(engine.ShapeOf(box, 0.5)), Vec3{0, 0.6, 0}))
			hashes[i] = run(world)
			ok(t, world.Close())
		}()
	}
	group.Wait()
	for _, hash := range hashes {
		if hash != hashes[0] {
			t.Fatal(hashes)
		}
	}
}

func TestAnotherLibraryIsRefused(t *testing.T) {
	ours := raw.Layout()
	ok(t, checkLayout(ours))
	for _, other := range []string{"0.0.1", "0.99.0", "99.0.0"} {
		err := checkLayout(strings.Replace(ours, raw.VERSION, other, 1))
		if e := fails(t, err, raw.CAROM_E_UNSUPPORTED); !strings.Contains(e.Message, " is of version ") {
			t.Fatal(e)
		}
	}
	_, row, _ := strings.Cut(ours, "carom_contact.separation ")
	row, _, _ = strings.Cut(row, "\n")
	moved := strings.Replace(ours, "separation "+row, "separation 4 8 f64", 1)
	if e := fails(t, checkLayout(moved), raw.CAROM_E_UNSUPPORTED); !strings.Contains(e.Message, "carom_contact.separation as "+row) {
		t.Fatal(e)
	}
	more := ours + "carom_contact.mood 0 8 f64\n"
	if e := fails(t, checkLayout(more), raw.CAROM_E_UNSUPPORTED); !strings.Contains(e.Message, "has no carom_contact.mood") {
		t.Fatal(e)
	}
}

// 65,535 engines and worlds may be alive in a process: more than that are made here, and given back.
func TestNothingIsLeftAlive(t *testing.T) {
	for range 33_000 {
		engine := must(NewEngine(1))
		world := must(engine.World())
		ok(t, world.Close())
		ok(t, engine.Close())
	}
}

func BenchmarkPosition(b *testing.B) {
	engine := must(NewEngine(1))
	world := must(engine.World())
	body := must(world.Body(must(engine.Shape("sphere", 0.5)), Vec3{}))
	for b.Loop() {
		must(world.Position(body))
	}
}
