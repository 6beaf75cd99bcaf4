package carom

/*
#cgo pkg-config: carom
#cgo linux LDFLAGS: -ldl
#define _GNU_SOURCE
#include <carom/carom.h>
#ifndef _WIN32
#include <dlfcn.h>
#endif

static const char *carom_file(void) {
#ifndef _WIN32
  Dl_info info;
  if (dladdr(carom_abi_manifest(), &info) && info.dli_fname) return info.dli_fname;
#endif
  return "libcarom";
}
*/
import "C"

import (
	"fmt"
	"slices"
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

// Is the library that was loaded one that package raw can call? Compared once: version, and the layout of every struct.
var checkLibrary = sync.OnceValue(func() error {
	return checkManifest(raw.AbiManifest(), C.GoString(C.carom_file()))
})

func checkManifest(manifest, file string) error {
	refuse := func(what string, arguments ...any) error {
		return &Error{Code: Code(raw.CAROM_E_UNSUPPORTED), Message: file + " " + fmt.Sprintf(what, arguments...),
			Remedy: "install a libcarom and a module of one version, or build the program against that library anew"}
	}
	version, lines, _ := strings.Cut(strings.TrimPrefix(manifest, "carom "), "\n")
	var here, there [3]int
	fmt.Sscanf(raw.VERSION, "%d.%d.%d", &here[0], &here[1], &here[2])
	_, err := fmt.Sscanf(version, "%d.%d.%d", &there[0], &there[1], &there[2])
	same := there[0] == here[0] && (here[0] > 0 || there[1] == here[1]) // 0.10 differs from 0.9
	if err != nil || !same || slices.Compare(there[:], here[:]) < 0 {
		return refuse("is of version %s, this module of %s", version, raw.VERSION)
	}
	rows := map[string]raw.Row{}
	for _, line := range strings.Split(lines, "\n") {
		var row raw.Row
		fmt.Sscanf(line, "%s %d %d %s", &row.Name, &row.Offset, &row.Size, &row.Kind)
		rows[row.Name] = row
	}
	for _, ours := range raw.Layout {
		theirs, there := rows[ours.Name]
		longer := theirs.Kind == "struct" && ours.Kind == "struct" && theirs.Size > ours.Size // a newer one's: the tail is not ours
		if !there {
			return refuse("has no %s", ours.Name)
		} else if theirs != ours && !longer {
			return refuse("has %s as %s of %d bytes at %d, this module as %s of %d bytes at %d", ours.Name,
				theirs.Kind, theirs.Size, theirs.Offset, ours.Kind, ours.Size, ours.Offset)
		}
	}
	return nil
}
