package carom

import (
	"strings"
	"sync"

	"carom/raw"
)

// Code is a result, raw.CAROM_E_*: errors.Is(err, carom.Code(raw.CAROM_E_BUSY)).
type Code int32

func (code Code) Error() string { return raw.ResultName(int32(code)) }

// Error says what was wrong, and what to do. Nothing has changed.
type Error struct {
	Code     Code
	Argument int // 1-based position of the argument at fault in the C signature, 0: none in particular
	Message  string
	Remedy   string
	Witness  *[2]Vec3 // direction and point that prove a support function false
}

func (e *Error) Error() string { return e.Message + ". Remedy: " + e.Remedy }

// Unwrap gives the code.
func (e *Error) Unwrap() error { return e.Code }

// The library writes one on failure only, so they are used again and again.
var details = sync.Pool{New: func() any { e := raw.NewError(); return &e }}

func check(call func(e *raw.Error) int32) error {
	e := details.Get().(*raw.Error)
	defer details.Put(e)
	code := call(e)
	if code == raw.CAROM_OK {
		return nil
	}
	failed := &Error{Code: Code(code), Argument: int(e.Argument), Message: text(e.Message[:]), Remedy: text(e.Remedy[:])}
	if e.HasWitness == 1 {
		failed.Witness = &[2]Vec3{e.WitnessDir, e.WitnessOut}
	}
	return failed
}

func text(bytes []byte) string {
	before, _, _ := strings.Cut(string(bytes), "\x00")
	return before
}

// Is the library that was loaded one that package raw can call? Asked once: version, and the layout of every struct.
var checkLibrary = sync.OnceValue(func() error { return checkLayout(raw.Layout()) })

func checkLayout(layout string) error {
	return check(func(e *raw.Error) int32 { return raw.AbiCheck(cstring(layout), e) })
}
