// Package carom is a rigid-body physics engine: the same bits on every machine, shapes of your own. SI units, radians,
// quaternions x, y, z, w. Package raw has all of the C interface; Engine.Call and World.Call make the
// calls that have no method here.
package carom

import (
	"sync"
	"unsafe"

	"carom/raw"
)

// Handles are numbers, which the library validates in every call. Descriptors come from raw.NewBodyDesc and its like.
type (
	Body         = raw.Body
	BodyDesc     = raw.BodyDesc
	Collider     = raw.Collider
	ColliderDesc = raw.ColliderDesc
	Contact      = raw.Contact
	Joint        = raw.Joint
	JointDesc    = raw.JointDesc
	Material     = raw.Material
	MaterialDesc = raw.MaterialDesc
	Plugin       = raw.Plugin
	Shape        = raw.Shape
	Vec3         = [3]float64
	Quat         = [4]float64
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
	var pointer *raw.Engine
	if err := check(func(e *raw.Error) int32 { return raw.EngineCreate(nil, &pointer, e) }); err != nil {
		return nil, err
	}
	engine := &Engine{pointer: pointer}
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
	if err := check(func(e *raw.Error) int32 { return raw.EngineDestroy(engine.pointer, e) }); err != nil {
		return err
	}
	engine.pointer = nil
	for _, kept := range engine.kept {
		kept.free()
	}
	engine.kept = nil
	return nil
}

// Call makes any call of package raw on this engine.
func (engine *Engine) Call(call func(p *raw.Engine, e *raw.Error) int32) error {
	return check(func(e *raw.Error) int32 { return call(engine.pointer, e) })
}

// Shape makes one by the name of its plugin: "sphere", "box", "half_space", or one on $CAROM_PLUGIN_PATH.
func (engine *Engine) Shape(name string, params ...float64) (shape Shape, err error) {
	err = engine.Call(func(p *raw.Engine, e *raw.Error) int32 {
		return raw.ShapeCreateNamed(p, cstring(name), first(params), uint64(len(params)), &shape, e)
	})
	return
}

// ShapeOf makes one of a plugin.
func (engine *Engine) ShapeOf(plugin Plugin, params ...float64) (shape Shape, err error) {
	err = engine.Call(func(p *raw.Engine, e *raw.Error) int32 {
		return raw.ShapeCreate(p, plugin, first(params), uint64(len(params)), &shape, e)
	})
	return
}

// World makes an empty world, with gravity along -y.
func (engine *Engine) World() (*World, error) {
	var pointer *raw.World
	err := engine.Call(func(p *raw.Engine, e *raw.Error) int32 { return raw.WorldCreate(p, nil, &pointer, e) })
	if err != nil {
		return nil, err
	}
	return &World{pointer, engine}, nil
}

func cstring(text string) *byte {
	return &append([]byte(text), 0)[0]
}

var none float64

// Never nil: a shape may have no parameters.
func first(params []float64) *float64 {
	if len(params) == 0 {
		return &none
	}
	return &params[0]
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
	if err := check(func(e *raw.Error) int32 { return raw.WorldDestroy(world.pointer, e) }); err != nil {
		return err
	}
	world.pointer = nil
	return nil
}

// Engine is the one that made this world.
func (world *World) Engine() *Engine { return world.engine }

// Call makes any call of package raw on this world.
func (world *World) Call(call func(p *raw.World, e *raw.Error) int32) error {
	return check(func(e *raw.Error) int32 { return call(world.pointer, e) })
}

// Step advances by dt seconds.
func (world *World) Step(dt float64) error {
	return check(func(e *raw.Error) int32 { return raw.WorldStep(world.pointer, dt, e) })
}

// SetDial takes raw.CAROM_DIAL_*.
func (world *World) SetDial(dial uint32, value float64) error {
	return check(func(e *raw.Error) int32 { return raw.WorldSetDial(world.pointer, dial, value, e) })
}

// Hash is of all that a step changes: it compares two runs.
func (world *World) Hash() (hash uint64, err error) {
	err = check(func(e *raw.Error) int32 { return raw.WorldHash(world.pointer, &hash, e) })
	return
}

// Material makes a surface for colliders.
func (world *World) Material(desc MaterialDesc) (material Material, err error) {
	err = check(func(e *raw.Error) int32 { return raw.MaterialCreate(world.pointer, &desc, &material, e) })
	return
}

// Body makes a dynamic body of one shape, of density 1000 kg/m^3.
func (world *World) Body(shape Shape, position Vec3) (Body, error) {
	desc, part := raw.NewBodyDesc(), raw.NewColliderDesc()
	desc.Position, part.Shape = position, shape
	return world.BodyOf(desc, part)
}

// BodyOf makes a body of any number of shapes.
func (world *World) BodyOf(desc BodyDesc, parts ...ColliderDesc) (body Body, err error) {
	if err = check(func(e *raw.Error) int32 { return raw.BodyCreate(world.pointer, &desc, &body, e) }); err != nil {
		return
	}
	var collider Collider
	for i := range parts {
		err = check(func(e *raw.Error) int32 { return raw.ColliderCreate(world.pointer, body, &parts[i], &collider, e) })
		if err != nil {
			world.Destroy(body)
			return 0, err
		}
	}
	return
}

// Ground makes a static half-space below height.
func (world *World) Ground(height float64) (Body, error) {
	shape, err := world.engine.Shape("half_space", 0, 1, 0, height)
	if err != nil {
		return 0, err
	}
	desc, part := raw.NewBodyDesc(), raw.NewColliderDesc()
	desc.Type, part.Shape = raw.CAROM_BODY_STATIC, shape
	return world.BodyOf(desc, part)
}

// Destroy takes a body away, with its colliders and joints.
func (world *World) Destroy(body Body) error {
	return check(func(e *raw.Error) int32 { return raw.BodyDestroy(world.pointer, body, e) })
}

// Joint connects two bodies, or one and the world.
func (world *World) Joint(desc JointDesc) (joint Joint, err error) {
	err = check(func(e *raw.Error) int32 { return raw.JointCreate(world.pointer, &desc, &joint, e) })
	return
}

// Position is the origin of a body's frame.
func (world *World) Position(body Body) (position Vec3, err error) {
	err = check(func(e *raw.Error) int32 { return raw.BodyGetPose(world.pointer, body, &position[0], nil, e) })
	return
}

// Pose is a body's position and orientation.
func (world *World) Pose(body Body) (pose Pose, err error) {
	err = check(func(e *raw.Error) int32 {
		return raw.BodyGetPose(world.pointer, body, &pose.Position[0], &pose.Orientation[0], e)
	})
	return
}

// SetPose moves a body at once.
func (world *World) SetPose(body Body, pose Pose) error {
	return check(func(e *raw.Error) int32 {
		return raw.BodySetPose(world.pointer, body, &pose.Position[0], &pose.Orientation[0], e)
	})
}

// SetVelocity takes m/s of the centre of mass, and rad/s.
func (world *World) SetVelocity(body Body, linear, angular Vec3) error {
	return check(func(e *raw.Error) int32 { return raw.BodySetVelocity(world.pointer, body, &linear[0], &angular[0], e) })
}

// AddForce adds a force and a torque, N and N m, for the next step.
func (world *World) AddForce(body Body, force, torque Vec3) error {
	return check(func(e *raw.Error) int32 { return raw.BodyAddForce(world.pointer, body, &force[0], &torque[0], e) })
}

// Bodies gives all handles.
func (world *World) Bodies() ([]Body, error) {
	return list(func(dst *Body, capacity uint64, count *uint64, e *raw.Error) int32 {
		return raw.WorldGetBodies(world.pointer, dst, capacity, count, e)
	})
}

// Contacts gives the contact points of the last step.
func (world *World) Contacts() ([]Contact, error) {
	return list(func(dst *Contact, capacity uint64, count *uint64, e *raw.Error) int32 {
		return raw.WorldGetContacts(world.pointer, dst, uint64(unsafe.Sizeof(*dst)), capacity, count, e)
	})
}

// Save gives the state as bytes; flags are raw.CAROM_SNAPSHOT_*.
func (world *World) Save(flags uint32) ([]byte, error) {
	return list(func(dst *byte, capacity uint64, count *uint64, e *raw.Error) int32 {
		code := raw.WorldSave(world.pointer, flags, unsafe.Pointer(dst), capacity, count, e)
		if code == raw.CAROM_E_BUFFER_TOO_SMALL {
			return raw.CAROM_OK // list asks again
		}
		return code
	})
}

// Restore puts back what Save gave.
func (world *World) Restore(bytes []byte) error {
	return check(func(e *raw.Error) int32 {
		return raw.WorldRestore(world.pointer, unsafe.Pointer(unsafe.SliceData(bytes)), uint64(len(bytes)), e)
	})
}

// Fork makes a copy that goes on bit for bit as this world does. Close it, too.
func (world *World) Fork() (*World, error) {
	var copy *raw.World
	if err := check(func(e *raw.Error) int32 { return raw.WorldFork(world.pointer, &copy, e) }); err != nil {
		return nil, err
	}
	return &World{copy, world.engine}, nil
}
