"""Calls of the C library's mathematics: bits must not depend on whose library it is. Prints every call in the object
files that is not of an exact function, and fails if there is one.

Usage: check_libm.py NM CC SCRATCH FILE...   FILE: an object file, an archive or a shared object"""
import os
import re
import subprocess
import sys

# IEEE 754 leaves them one result, and every library gives it. fma() is not among them: MinGW's rounds twice.
EXACT = set("""ceil copysign fabs fdim floor fmax fmin fmod frexp ilogb ldexp llrint llround logb lrint lround modf nan
nearbyint nextafter remainder remquo rint round roundeven scalbln scalbn sqrt trunc
fpclassify isfinite isinf isnan signbit finite""".split())
# What else <math.h> and its extensions have.
ROUNDED = set("""acos acosh acospi asin asinh asinpi atan atan2 atan2pi atanh atanpi cbrt compoundn cos cosh cospi drem
erf erfc exp exp10 exp2 expm1 fma gamma hypot j0 j1 jn lgamma lgamma_r log log10 log10p1 log1p log2 log2p1 logp1 pow pow10
powi pown powr rootn rsqrt scalb significand sin sincos sinh sinpi tan tanh tanpi tgamma y0 y1 yn
cabs cacos cacosh carg casin casinh catan catanh ccos ccosh cexp clog cpow csin csinh csqrt ctan ctanh""".split())
CURE = """Use what src/core has: sin_cos() of trig.h, angle_of() of wide_angle.h, logarithm() of logarithm.h, multiply_add() of
multiply_add.h. For another function write one of sums, products, quotients and roots beside them. A function that
IEEE 754 leaves one result, which every library gives, goes into EXACT of tests/abi/check_libm.py."""


def function_of(symbol):
    """The function of <math.h> that a symbol stands for, or None."""
    name = symbol.split("@")[0]
    if name.startswith("_ZGV"):  # a vector of them: _ZGVbN2v_sin
        name = name.rsplit("v_", 1)[-1]
    name = re.sub(r"^_+", "", name)
    name = re.sub(r"(_finite|_stret|df2|sf2)$", "", name)
    for known in (name, name[:-1] if name.endswith(("f", "l")) else name):
        if known in EXACT or known in ROUNDED:
            return known
    return None


def calls_of(nm, file):
    """{function: symbol} of what a file leaves to the C library, and how many symbols it has."""
    shared = ["-D"] if re.search(r"\.so[.0-9]*$", file) else []
    run = subprocess.run([nm, "-u", *shared, file], stdout=subprocess.PIPE, universal_newlines=True)
    if run.returncode != 0:
        sys.exit(f"nm failed on {file}")
    symbols = [line.split()[-1] for line in run.stdout.splitlines() if len(line.split()) > 1]
    return {function_of(s): s for s in symbols if function_of(s)}, len(symbols)


def look_at(nm, files):
    """What is wrong, a line each; what is called and exact; how many symbols there were."""
    wrong, exact, count = [], set(), 0
    for file in files:
        calls, symbols = calls_of(nm, file)
        count += symbols
        exact |= calls.keys() & EXACT
        wrong += [f"{os.path.basename(file)} calls {calls[name]}()" for name in sorted(calls.keys() - EXACT)]
    return wrong, exact, count


def finds(nm, compiler, scratch):
    """Whether a file that calls them is seen: else this check looks at nothing."""
    os.makedirs(scratch, exist_ok=True)
    source, made = os.path.join(scratch, "calls.c"), os.path.join(scratch, "calls.o")
    asked = {"sin": "sin(x)", "powf": "powf((float)x, 3.3f)", "fma": "fma(x, x, 3)", "hypotl": "(double)hypotl(x, 2)"}
    with open(source, "w", encoding="utf-8") as file:
        file.write("#include <math.h>\ndouble calls(double x);\n"
                   f"double calls(double x) {{ return floor(x) + {' + '.join(asked.values())}; }}\n")
    subprocess.run([compiler, "-c", "-O0", source, "-o", made], check=True)
    calls, _ = calls_of(nm, made)
    # A processor that has fma() as an instruction calls nothing, and rounds once.
    return all(name in calls.values() for name in asked if name != "fma")


def main(nm, compiler, scratch, files):
    if not finds(nm, compiler, scratch):
        sys.exit("a file that calls sin() and pow() is not seen: this check is blind")
    wrong, exact, count = look_at(nm, files)
    print(f"{len(files)} files, {count} symbols from outside; exact functions: {', '.join(sorted(exact)) or 'none'}")
    if not files or count == 0:
        sys.exit("no symbols: this check looks in the wrong place")
    for line in wrong:
        print(f"  {line}")
    if wrong:
        print(f"Libraries round these differently, so platforms would differ in their last bits.\n{CURE}")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:]))
