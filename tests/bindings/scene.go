// The scene of scene.c by way of the module; prints its hashes, then those of it with a double cone whose function is Go.
package main

import (
	"fmt"
	"math"
	"os"

	"carom"
	"carom/raw"
)

// plugins/template/template.c, operation by operation.
func topSupport(params []float64, d carom.Vec3) carom.Vec3 {
	r, h, x, y, z := params[0], params[1], d[0], d[1], d[2]
	side := max(math.Abs(x), math.Abs(z))
	largest := max(side, math.Abs(y))
	length := 0.0
	if side > 0 {
		x /= side
		z /= side
		length = math.Sqrt(float64(x*x) + float64(z*z)) // float64(): rounded, on processors that would fuse
		x /= length
		z /= length
	}
	if h*(math.Abs(y)/largest) > r*(length*(side/largest)) {
		return carom.Vec3{0, math.Copysign(h, y), 0}
	}
	return carom.Vec3{r * x, 0, r * z}
}

func must[T any](value T, err error) T {
	check(err)
	return value
}

func check(err error) {
	if err != nil {
		fmt.Fprintln(os.Stderr, err)
		os.Exit(1)
	}
}

func hashes(engine *carom.Engine, top carom.Shape) {
	shapes := []carom.Shape{must(engine.Shape("sphere", 0.3)), must(engine.Shape("box", 0.4, 0.25, 0.3)), top}
	world := must(engine.World())
	check(world.SetDial(raw.CAROM_DIAL_SUBSTEPS, 5))
	check(world.SetWind(carom.Vec3{1.5, 0, 0.5}))
	surface := raw.NewMaterialDesc()
	surface.Friction, surface.Restitution = 0.6, 0.3
	material := must(world.Material(surface))
	for i := range 19 {
		desc, part := raw.NewBodyDesc(), raw.NewColliderDesc()
		part.Material = material
		if i == 0 {
			desc.Type, part.Shape = raw.CAROM_BODY_STATIC, must(engine.Shape("half_space", 0, 1, 0, 0))
		} else {
			n := float64(i)
			desc.Position = carom.Vec3{float64(i%3) * 0.5, 0.6 + float64(n*0.55), float64(i%2) * 0.4}
			desc.AngularVelocity = carom.Vec3{0.5 * n, 0, 1}
			part.Shape, part.Density = shapes[i%3], 400+50*n
		}
		body := must(world.BodyOf(desc, part))
		if i > 0 {
			check(world.SetDrag(body, 0.1, 0.02))
		}
	}
	hinge := raw.NewJointDesc()
	hinge.Kind, hinge.Fields, hinge.BodyB = raw.CAROM_JOINT_HINGE, raw.CAROM_JOINT_WORLD_FRAME, must(world.Body(shapes[1], carom.Vec3{4.5, 3, 0}))
	hinge.PositionA, hinge.OrientationA = carom.Vec3{4, 3, 0}, carom.Quat{0, -0.6, 0, 0.8}
	must(world.Joint(hinge))
	for range 3 {
		for range 60 {
			check(world.Step(1.0 / 60))
		}
		fmt.Printf("%016x\n", must(world.Hash()))
	}
	check(world.Close())
}

func main() {
	engine := must(carom.NewEngine(1))
	size := func(name string) carom.Param { return carom.Param{Name: name, Unit: "m", Min: 1e-9, Max: 1e8} }
	kind := must(engine.Plugin("test.top", []carom.Param{size("radius"), size("half_height")}, topSupport))
	hashes(engine, must(engine.Shape("template", 0.35, 0.4)))
	hashes(engine, must(engine.ShapeOf(kind, 0.35, 0.4)))
	check(engine.Close())
}
