// Package carom is a rigid-body physics engine: the same bits on every machine, shapes of your own. SI units, radians,
// quaternions x, y, z, w. Methods have the names of C's functions without the noun: World.SetVelocity is
// carom_body_set_velocity(). Package raw has all of the C interface; Engine.Call and World.Call make the calls that have no
// method.
package carom

import (
	"carom/raw"
	"sync"
)

// Handles are numbers, which the library validates in every call. Descriptors come from raw.NewBodyDesc and its like.
type (
	Body         = raw.Body
	BodyDesc     = raw.BodyDesc
	Collider     = raw.Collider
	ColliderDesc = raw.ColliderDesc
	Contact      = raw.Contact
	JointDesc    = raw.JointDesc
	MaterialDesc = raw.MaterialDesc
	Plugin       = raw.Plugin
	Shape        = raw.Shape
)

// Engine owns plugins and shapes, and makes worlds. Close gives it back, after its worlds.
type Engine struct {
	pointer *raw.Engine
	lock    sync.Mutex // of kept
	kept    []kept
}

// NewEngine makes an engine whose steps the given number of threads share; the outcome is the same to the bit.
func NewEngine(threads int) (*Engine, error) {
	if err := checkLibrary(); err != nil {
		return nil, err
	}
	engine := &Engine{}
	if err := check(func(e *raw.Error) int32 { return raw.EngineCreate(nil, &engine.pointer, e) }); err != nil {
		return nil, err
	}
	if threads > 1 {
		jobs := raw.NewJobsDesc()
		jobs.Threads = uint32(threads)
		if err := engine.Call(func(p *raw.Engine, e *raw.Error) int32 { return raw.EngineSetJobs(p, &jobs, e) }); err != nil {
			engine.Close()
			return nil, err
		}
	}
	return engine, nil
}

// Close gives back all memory. It fails while worlds are open. Closing twice does nothing.
func (engine *Engine) Close() error {
	if engine.pointer == nil {
		return nil
	}
	if err := engine.Call(raw.EngineDestroy); err != nil {
		return err
	}
	engine.pointer = nil
	for _, kept := range engine.kept {
		kept.free()
	}
	return nil
}

// Call makes any call of package raw on this engine.
func (engine *Engine) Call(call func(p *raw.Engine, e *raw.Error) int32) error {
	return check(func(e *raw.Error) int32 { return call(engine.pointer, e) })
}

// World makes an empty world, with gravity along -y.
func (engine *Engine) World() (*World, error) {
	var pointer *raw.World
	err := engine.Call(func(p *raw.Engine, e *raw.Error) int32 { return raw.WorldCreate(p, nil, &pointer, e) })
	return &World{pointer, engine}, err
}

// World has bodies and steps them. Any number of goroutines may read it at once; beside one that changes it others get
// CAROM_E_BUSY.
type World struct {
	pointer *raw.World
	engine  *Engine
}

// Close gives back all memory. Closing twice does nothing; other calls on a closed world fail.
func (world *World) Close() error {
	if world.pointer == nil {
		return nil
	}
	err := world.Call(raw.WorldDestroy)
	if err == nil {
		world.pointer = nil
	}
	return err
}

// Engine is the one that made this world.
func (world *World) Engine() *Engine { return world.engine }

// Call makes any call of package raw on this world.
func (world *World) Call(call func(p *raw.World, e *raw.Error) int32) error {
	return check(func(e *raw.Error) int32 { return call(world.pointer, e) })
}

// Body makes a dynamic body of one shape, of density 1000 kg/m^3.
func (world *World) Body(shape Shape, position Vec3) (Body, error) {
	return world.body(shape, position, raw.CAROM_BODY_DYNAMIC)
}

// Ground makes a static half-space below height.
func (world *World) Ground(height float64) (Body, error) {
	shape, err := world.engine.Shape("half_space", 0, 1, 0, height)
	if err != nil {
		return 0, err
	}
	return world.body(shape, Vec3{}, raw.CAROM_BODY_STATIC)
}

func (world *World) body(shape Shape, position Vec3, kind uint32) (Body, error) {
	desc, part := raw.NewBodyDesc(), raw.NewColliderDesc()
	desc.Type, desc.Position, part.Shape = kind, position, shape
	return world.BodyOf(desc, part)
}

// BodyOf makes a body of any number of shapes.
func (world *World) BodyOf(desc BodyDesc, parts ...ColliderDesc) (body Body, err error) {
	err = world.Call(func(p *raw.World, e *raw.Error) int32 { return raw.BodyCreate(p, &desc, &body, e) })
	for i := 0; err == nil && i < len(parts); i++ {
		if _, err = world.Collider(body, parts[i]); err != nil {
			world.Destroy(body)
			body = 0
		}
	}
	return
}

// Position is the origin of a body's frame.
func (world *World) Position(body Body) (position Vec3, err error) {
	err = check(func(e *raw.Error) int32 { return raw.BodyGetPose(world.pointer, body, &position[0], nil, e) })
	return
}

// Fork makes a copy that goes on bit for bit as this world does. Close it, too.
func (world *World) Fork() (*World, error) {
	var copy *raw.World
	err := world.Call(func(p *raw.World, e *raw.Error) int32 { return raw.WorldFork(p, &copy, e) })
	return &World{copy, world.engine}, err
}

// Positions reads those of all bodies, in the order of Bodies.
func (world *World) Positions(dst []Vec3) error {
	return Read(world, raw.CAROM_FIELD_POSITION, nil, dst)
}

// Poses reads those of all bodies, in the order of Bodies.
func (world *World) Poses(dst []Pose) error { return Read(world, raw.CAROM_FIELD_POSE, nil, dst) }
