"""From a file to a model that MuJoCo has compiled. Files come from strangers: what one names is looked at before it is opened."""
from __future__ import annotations

import math
import os
import re
from pathlib import Path
from typing import Any, Iterable, Sequence, Union
from xml.etree import ElementTree

import numpy as np

from . import collada
from .inertias import LEAST_MASS, LEAST_TURN, Said
from .problems import ModelError, Problems

MOST_BYTES = 64 << 20  # of a model's own text: larger is no model, and takes minutes to read
MOST_FILE_BYTES = 256 << 20  # of a mesh
MOST_FILES = 1000      # that one may include
MOST_COPIES = 100_000  # of what a model tells MuJoCo to repeat, and of numbers that it asks room for
MOST_ROWS = 1 << 14    # of a field of heights, as the library takes it

Source = Union[str, "os.PathLike[str]", Any]


def need_mujoco() -> Any:
    try:
        import mujoco  # type: ignore[import-untyped, import-not-found, unused-ignore]
    except ImportError as why:
        raise ImportError("carom.robots reads models by MuJoCo's parser, which is not here (pip install 'carom[robots]')") from why
    return mujoco


def spec(path: str | os.PathLike[str], root: str | os.PathLike[str] | None = None, packages: Sequence[str | os.PathLike[str]] = ()) -> Any:
    """A mujoco.MjSpec of a file of MJCF or URDF, to be edited before load(). Every file that it names has been found, in the folder
    `root` or a package, and has its whole path.
    @param root, packages  @see load()   @raise ModelError"""
    mujoco = need_mujoco()
    path = Path(path)
    folder = Path(root) if root is not None else path.resolve().parent
    check_texts(path, folder)
    try:
        found = mujoco.MjSpec.from_file(str(path))
    except Exception as why:  # MuJoCo raises several kinds
        raise ModelError(str(path), first_line(why), "mend the model there") from None
    find_files(found, path, folder, [Path(package) for package in packages])
    return found


def compiled(source: Source, root: str | os.PathLike[str] | None, packages: Sequence[str | os.PathLike[str]], floating: bool,
             problems: Problems) -> Any:
    """@param source  a file of MJCF or URDF, or a mujoco.MjSpec   @return mujoco.MjModel"""
    mujoco = need_mujoco()
    if isinstance(source, mujoco.MjSpec):
        model, place = source.copy(), "the MjSpec"
    elif isinstance(source, (str, os.PathLike)):
        model, place = spec(source, root, packages), str(source)
    else:
        raise TypeError(f"source takes a path or a mujoco.MjSpec, got {source!r}, which is of type {type(source).__name__}")
    drop_looks(model)
    if floating:
        for body in model.worldbody.bodies:
            if not list(body.joints):
                body.add_freejoint()
    model.compiler.discardvisual = True
    model.compiler.fusestatic = False
    return build(model, place, problems)


def first_line(why: BaseException) -> str:
    return " ".join(str(why).split())


# ---- what is opened ----

def check_texts(path: Path, folder: Path) -> None:
    """Look at a model's text, and at what it includes, before MuJoCo does."""
    seen: set[Path] = set()
    ahead = [path]
    while ahead:
        file = ahead.pop()
        real = file.resolve()
        if real in seen:
            continue
        seen.add(real)
        if len(seen) > MOST_FILES:
            raise ModelError(str(path), f"it includes more than {MOST_FILES} files", "make one file of it")
        tree = read_text(file)
        check_counts(tree, str(file))
        for element in tree.iter():
            name = element.get("file")
            if name and element.tag in ("include", "model"):
                ahead.append(inside(path.resolve().parent / name, folder, str(file), f"includes {name!r}"))
            elif name and element.tag == "flexcomp":
                inside(path.resolve().parent / name, folder, str(file), f"names {name!r}")


def check_counts(tree: ElementTree.Element, place: str) -> None:
    """What makes much of little text: repeated bodies, grids, room that is asked for."""
    ahead = [(tree, 1.0)]
    while ahead:
        element, copies = ahead.pop()
        asked = [copies]
        if element.tag in ("replicate", "composite", "flexcomp"):
            counts = [abs(number) for number in numbers(element.get("count"))]
            asked = [copies * math.prod(counts)]
            copies = asked[0] if element.tag == "replicate" else copies
        elif element.tag == "size":
            asked = [abs(number) for name, text in element.items() if name.startswith(("nkey", "nuser")) for number in numbers(text)]
        elif element.tag == "hfield":
            asked = [abs(number) * MOST_COPIES / MOST_ROWS for name in ("nrow", "ncol") for number in numbers(element.get(name))]
        if not all(number <= MOST_COPIES for number in asked):
            raise ModelError(place, f"a <{element.tag}> asks for {max(asked):g} things, more than {MOST_COPIES}", "make the model smaller")
        ahead += [(child, copies) for child in element]


def numbers(text: str | None) -> list[float]:
    found = []
    for word in (text or "").split():
        try:
            found.append(float(word))
        except ValueError:  # MuJoCo says what is wrong with it
            continue
    return found


def read_text(file: Path) -> ElementTree.Element:
    try:
        size = file.stat().st_size
        text = file.read_bytes() if size <= MOST_BYTES else b""
    except OSError as why:
        raise ModelError(str(file), f"it can't be read: {why.strerror}", "give the path of an MJCF or URDF file") from None
    if size > MOST_BYTES:
        raise ModelError(str(file), f"it has {size} bytes; a model has at most {MOST_BYTES}",
                         "keep meshes and fields of heights in files of their own")
    if b"<!DOCTYPE" in text or b"<!ENTITY" in text:
        raise ModelError(str(file), "it declares entities, which may grow without end", "take the <!DOCTYPE> out")
    try:
        return ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError, RecursionError) as why:
        raise ModelError(str(file), f"it is no XML: {why}", "mend the model there") from None


def inside(file: Path, folder: Path, place: str, what: str) -> Path:
    real = file.resolve()
    if not real.is_relative_to(folder.resolve()):
        raise ModelError(place, f"it {what}, which lies outside {folder}", "if the file is to be trusted, pass a folder that has both: root=")
    if not real.is_file():
        raise ModelError(place, f"it {what}, but there is no file {file}", "put it there, or mend the model")
    if real.stat().st_size > MOST_FILE_BYTES:
        raise ModelError(place, f"it {what}, a file of {real.stat().st_size} bytes; it may have {MOST_FILE_BYTES}", "make it smaller")
    return file


def find_files(spec: Any, path: Path, folder: Path, packages: Sequence[Path]) -> None:
    """Say where each mesh and field of heights lies, inside `folder` or a package."""
    here = path.resolve().parent
    for kind, things in (("mesh", spec.meshes), ("hfield", spec.hfields)):
        for thing in things:
            if not thing.file:
                continue
            what = f"names {thing.file!r} for {kind} {thing.name!r}"
            package = re.match(r"(?:package|model):/+([^/]+)/(.*)", thing.file)
            if package:
                found, of = in_package(package[1], package[2], path, packages)
                if found is None:
                    raise ModelError(str(path), f"it {what}, but no folder above the file is named {package[1]!r}",
                                     f"pass the folder that has {package[1]!r} in it: packages=[...]")
                thing.file = str(inside(found, of, str(path), what).resolve())
            else:
                name = thing.file[len("file://"):] if thing.file.startswith("file://") else thing.file
                file = here / spec.meshdir / name
                if not file.is_file() and (here / name).is_file():
                    file = here / name
                thing.file = str(inside(file, folder, str(path), what).resolve())


def in_package(name: str, rest: str, path: Path, packages: Iterable[Path]) -> tuple[Path | None, Path]:
    """@return the file, and the folder of its package; (None, ...) where no package has that name"""
    for above in [*packages, *path.resolve().parents]:
        for folder in (above / name, above):
            if folder.name == name and folder.is_dir() and (folder / rest).exists():
                return folder / rest, folder
    for above in [*packages, *path.resolve().parents]:
        if (above / name).is_dir() or above.name == name:
            return (above / name if (above / name).is_dir() else above) / rest, above
    return None, path


# ---- what is built ----

def drop_looks(spec: Any) -> None:
    """Textures and materials move nothing, and their files may be missing."""
    for things in (spec.geoms, spec.sites, spec.tendons):
        for thing in things:
            thing.material = ""
    for things in (spec.skins, spec.materials, spec.textures):
        for thing in list(things):
            spec.delete(thing)


def mend_meshes(spec: Any, problems: Problems) -> None:
    """MuJoCo reads binary STL, OBJ and MSH. STL in words and Collada are put in numbers here; what nobody reads is left out."""
    unread: dict[str, str] = {}
    for mesh in spec.meshes:
        ending, corners = Path(mesh.file).suffix.lower(), None
        if ending == ".stl" and Path(mesh.file).is_file():
            corners = words_of_stl(Path(mesh.file).read_bytes())
        elif ending == ".dae":
            corners = collada.triangles(read_text(Path(mesh.file)))
        elif mesh.file and ending not in (".obj", ".msh"):
            corners = "of a kind that is not read: make it an OBJ, a binary STL or a Collada file"
        if isinstance(corners, str):
            unread[mesh.name] = corners
        elif corners is not None:
            mesh.file = ""
            mesh.uservert = corners.ravel()
            mesh.userface = np.arange(len(corners))
    for geom in list(spec.geoms):
        if geom.meshname in unread:
            problems.add("geom", geom.name or geom.meshname, f"its mesh: {unread[geom.meshname]}")
            spec.delete(geom)
    for mesh in list(spec.meshes):
        if mesh.name in unread:
            spec.delete(mesh)


def words_of_stl(data: bytes) -> Any:
    """@return corners, three a triangle, of an STL in words; None: it is in bytes"""
    if not data.lstrip()[:5].lower() == b"solid" or len(data) >= 84 and len(data) == 84 + 50 * int.from_bytes(data[80:84], "little"):
        return None
    corners = np.array([row.split() for row in re.findall(rb"vertex\s+(\S+\s+\S+\s+\S+)", data)], dtype=float)
    return corners if len(corners) >= 3 and len(corners) % 3 == 0 else None


def build(spec: Any, place: str, problems: Problems) -> Any:
    """Compile. What MuJoCo refuses for a body or mesh is mended by its own means, and told of."""
    mend_meshes(spec, problems)
    said_of = Said(spec, place)
    for _ in range(1000):  # each time another body or mesh
        try:
            model = spec.compile()
            said_of.settle(model, problems)
            return model
        except ModelError:
            raise
        except Exception as why:  # MuJoCo raises several kinds
            said = first_line(why)
        name = re.search(r"Element name '([^']*)'", said)
        if not (name and mend(spec, said, name[1], said_of, problems)):
            break
    raise ModelError(place, said, "mend the model there")


def mend(spec: Any, said: str, name: str, said_of: Said, problems: Problems) -> bool:
    """@return whether there is something to try"""
    if "discarding visual geoms" in said and spec.compiler.discardvisual:
        spec.compiler.discardvisual = False
        return True
    body = next((body for body in spec.bodies if body.name == name), None)
    if "A + B >= C" in said and not spec.compiler.balanceinertia:
        spec.compiler.balanceinertia = True
        problems.add("body", name, "its moments of inertia break A + B >= C: their mean stands for all three")
        return True
    if "mass and inertia of moving bodies" in said and body is not None and body.mass != LEAST_MASS:
        said_of.stand_in(body, LEAST_MASS, LEAST_TURN)
        return True
    if "mesh volume is too small" in said:
        mesh = next((mesh for mesh in spec.meshes if mesh.name == name), None)
        shell = need_mujoco().mjtMeshInertia.mjMESH_INERTIA_SHELL
        if mesh is None or mesh.inertia == shell:
            return False
        mesh.inertia = shell
        if weighs(spec, name):
            problems.add("mesh", name, "it encloses nothing: where bodies weigh what it holds they weigh its surface")
        return True
    return False


def weighs(spec: Any, mesh: str) -> bool:
    """Whether what a mesh holds counts for a body's mass."""
    always = int(spec.compiler.inertiafromgeom) == int(need_mujoco().mjtInertiaFromGeom.mjINERTIAFROMGEOM_TRUE)
    return any(geom.meshname == mesh and (always or not geom.parent.explicitinertial) for geom in spec.geoms)
