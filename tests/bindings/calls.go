// calls.c by way of the module.
package main

import (
	"fmt"
	"time"

	"carom"
)

func must[T any](value T, err error) T {
	if err != nil {
		panic(err)
	}
	return value
}

func timed(n int, each func(i int)) float64 {
	start := time.Now()
	for i := range n {
		each(i)
	}
	return float64(time.Since(start).Nanoseconds()) / float64(n)
}

func main() {
	engine := must(carom.NewEngine(1))
	world := must(engine.World())
	shape := must(engine.Shape("sphere", 0.5))
	bodies := make([]carom.Body, 10000)
	for i := range bodies {
		bodies[i] = must(world.Body(shape, carom.Vec3{2 * float64(i), 0, 0}))
	}
	positions := make([]carom.Vec3, len(bodies))
	single, bulk, sum := 1e99, 1e99, 0.0
	for range 7 {
		single = min(single, timed(200000, func(i int) { sum += must(world.Position(bodies[i%len(bodies)]))[0] }))
		bulk = min(bulk, timed(100, func(int) { must(0, world.Positions(positions)) }))
	}
	if sum <= 0 || positions[1][0] != 2 {
		panic("it did not read")
	}
	fmt.Printf("%.1f %.0f\n", single, bulk)
}
