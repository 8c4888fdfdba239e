"""Our pictures beside those of other renderers on the processor: the time that each takes to be equally like itself.

``python -m bench.rival_pictures LEVEL --out FOLDER [--mitsuba PYTHON] [--blender PROGRAM]
[--view X,Y,Z,PITCH,YAW,FOV] [--many SAMPLES] [--only RIVAL ...]``

PYTHON has the package ``mitsuba``; PROGRAM is Blender itself, or a Python with the package ``bpy``. All draw the same
triangles with the same textures in the light of the level's sun, with its shadows, under a sky. Each renderer's picture
is compared (structural similarity) with its own of so many samples that no more noise is seen; a rival takes the fewest
samples at which it is as like its own as ours is. Seconds are processor time of the picture alone: scenes are loaded,
trees built and kernels compiled before. Rivals are spared what ours draws besides: mask, depth, normal maps, lamps, and
surfaces that shine or that one sees through.
"""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
import time
from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from bench.blender_view import blender_words
from bench.rival_scripts import CYCLES, MITSUBA
from c4s.cli.levels import packs_of
from c4s.engine import backend
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world.state import world
from c4s.geometry.transform import rotation_matrix
from c4s.judge.paired.measures import pixel_measures
from c4s.packs.meshes import Mesh
from c4s.records.level import Level
from c4s.render import Camera, Grade, Instance, Lights, Renderer, SurfaceMaterial
from c4s.render.textures import decode_table, srgb_bytes

Linear: TypeAlias = NDArray[np.float32]
WIDTH, HEIGHT = 1280, 720
COUNTS = (1, 2, 4, 8, 16, 32, 64, 128)
"""Samples a pixel that a rival is tried with."""
MANY = 256
"""Samples a pixel of a rival's own reference, unless told otherwise."""
_FINER = 4
"""Our reference is so many times wider and higher, of 16 samples a pixel."""


@dataclass(frozen=True)
class RivalTrial:
    """One renderer at the fewest samples that are like its own reference."""

    renderer: str
    samples: int
    cpu_seconds: float
    similarity: float
    enough: bool
    """Whether it is as like its own reference as ours."""


def similarity(one: NDArray[np.uint8], other: NDArray[np.uint8]) -> float:
    """Structural similarity of two sRGB pictures."""
    return sum(pixel_measures(one / 255.0, other / 255.0).values())


def developed(linear: Linear, gain: float) -> NDArray[np.uint8]:
    """sRGB bytes of linear light."""
    return srgb_bytes(np.asarray(linear * np.float32(gain), dtype=np.float32))


def middle(linear: Linear) -> float:
    """The mean brightness that pictures are brought to a common exposure by."""
    return float(np.minimum(linear, 4.0).mean())


def shrunk(picture: NDArray[np.uint8], times: int) -> Linear:
    """Linear light of an sRGB picture, averaged over squares of ``times`` pixels."""
    height, width = picture.shape[0] // times, picture.shape[1] // times
    rows = [
        decode_table()[picture[y * times : (y + 1) * times]].reshape(times, width, times, 3).mean(axis=(0, 2))
        for y in range(height)
    ]
    return np.asarray(rows, dtype=np.float32)


def fewest(
    name: str, least: float, take: Callable[[int], tuple[Linear, float]], reference: Linear, mean: float
) -> tuple[RivalTrial, NDArray[np.uint8]]:
    """The first of ``COUNTS`` at which a renderer is as like its reference as ``least``, else the last.

    More samples are taken to be more alike.
    """
    gain = mean / max(middle(reference), 1e-9)
    wanted = developed(reference, gain)
    tried: dict[int, tuple[RivalTrial, NDArray[np.uint8]]] = {}

    def reaches(count: int) -> bool:
        linear, seconds = take(count)
        picture = developed(linear, gain)
        like = round(similarity(picture, wanted), 4)
        tried[count] = RivalTrial(name, count, round(seconds, 3), like, like >= least), picture
        return like >= least

    place = min(bisect_left(COUNTS, True, key=reaches), len(COUNTS) - 1)
    return tried[COUNTS[place]]


def by_material(meshes: Sequence[Mesh], instances: Sequence[Instance]) -> list[tuple[SurfaceMaterial, dict[str, Any]]]:
    """A scene's opaque triangles in right-handed metres, by material: corners with normals and texture coordinates."""
    parts: dict[int, list[tuple[NDArray[Any], ...]]] = {}
    kinds: dict[int, SurfaceMaterial] = {}
    flip = np.array([1.0, -1.0, 1.0])
    for one in instances:
        mesh = meshes[one.mesh]
        turned = np.linalg.det(one.matrix[:3, :3]) * np.linalg.inv(one.matrix[:3, :3]).T
        normals = mesh.normals @ turned.T
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        points = (mesh.vertices @ one.matrix[:3, :3].T + one.matrix[:3, 3]) * 0.01
        for slot in np.unique(mesh.face_slots).tolist():
            material = one.materials[slot] if slot < len(one.materials) else SurfaceMaterial()
            corners = mesh.faces[mesh.face_slots == slot][:, ::-1].reshape(-1)
            kinds[id(material)] = material
            parts.setdefault(id(material), []).append(
                (points[corners] * flip, normals[corners] * flip, mesh.uvs[corners])
            )
    names = ("points", "normals", "uvs")
    return [
        (
            kinds[key],
            {
                name: np.concatenate(arrays).astype(np.float32)
                for name, arrays in zip(names, zip(*rows, strict=True), strict=True)
            },
        )
        for key, rows in parts.items()
        if kinds[key].opacity == 1.0 and kinds[key].alpha == "opaque"
    ]


def hand_over(folder: Path, meshes: Sequence[Mesh], instances: Sequence[Instance], lights: Lights, cam: Camera) -> None:
    """Write a scene as both rivals read it: arrays, textures with their colour in them, and numbers."""
    turn = rotation_matrix(cam.rotation_deg)
    sun, sky = lights.sun, lights.sky
    materials = []
    for number, (material, arrays) in enumerate(by_material(meshes, instances)):
        np.savez(folder / f"{number}.npz", **arrays)
        texture = ""
        if material.texture is not None:
            texture = str(folder / f"{number}.png")
            painted = decode_table()[material.texture[..., :3]] * np.asarray(material.base_color, dtype=np.float32)
            Image.fromarray(srgb_bytes(painted)).save(texture, compress_level=1)
        materials.append(
            {
                "arrays": str(folder / f"{number}.npz"),
                "texture": texture,
                "color": [min(c, 1.0) for c in material.base_color],
                "roughness": max(material.roughness, 0.2),
                "metallic": material.metallic,
            }
        )
    told = {
        "materials": materials,
        "eye": (np.array(cam.location_cm) * [0.01, -0.01, 0.01]).tolist(),
        "ahead": (turn[:, 0] * [1, -1, 1]).tolist(),
        "fov_deg": cam.hfov_deg,
        "size": [cam.width, cam.height],
        "sun_way": (np.array(sun.direction) * [1, -1, 1]).tolist() if sun else None,
        "sun": [c * sun.intensity for c in sun.color] if sun else None,
        "sun_deg": sun.angle_deg if sun else 0.0,
        "sky": [0.5 * (a + b) * sky.intensity * sky.light for a, b in zip(sky.zenith, sky.horizon, strict=True)],
    }
    (folder / "scene.json").write_text(json.dumps(told))


class Rival:
    """A renderer in a process of its own that takes pictures of one scene when it is told to."""

    def __init__(self, name: str, words: Sequence[str]) -> None:
        self.name = name
        self._process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def take(self, samples: int, file: Path) -> tuple[Linear, float]:
        """Linear light of a picture, and its processor seconds."""
        assert self._process.stdin is not None and self._process.stdout is not None
        self._process.stdin.write(f"{samples} {file}\n")
        self._process.stdin.flush()
        for line in self._process.stdout:
            if line.startswith("TAKEN "):
                return np.load(file), float(line.split()[1])
        raise SystemExit(f"{self.name} ended before its picture was taken (exit {self._process.wait()})")

    def close(self) -> None:
        """End the process."""
        self._process.communicate()


def rivals(mitsuba: str | None, blender: str | None, scene: Path) -> list[tuple[str, list[str]]]:
    """Names of the rivals that are installed, and how each is started; a line of each that is not."""
    found: list[tuple[str, list[str]]] = []
    asks = [mitsuba or sys.executable, "-c", "import mitsuba"]
    if subprocess.run(asks, capture_output=True, check=False).returncode == 0:
        found += [
            (f"mitsuba {variant}", [asks[0], "-c", MITSUBA, "--", str(scene), variant])
            for variant in ("llvm_ad_rgb", "scalar_rgb")
        ]
    else:
        print(f"{asks[0]} has no package mitsuba: not compared (--mitsuba PYTHON)", file=sys.stderr)
    if blender is None or shutil.which(blender) is None:
        print("blender is not on the search path: not compared (--blender PROGRAM)", file=sys.stderr)
        return found
    script = scene / "in_blender.py"
    script.write_text(CYCLES)
    words = blender_words(blender, script)
    return [*found, *((f"cycles {variant}", [*words, str(scene), variant]) for variant in ("plain", "denoised"))]


def ours(
    meshes: Sequence[Mesh], instances: Sequence[Instance], lights: Lights, camera: Camera
) -> tuple[RivalTrial, NDArray[np.uint8], float]:
    """Our picture at its usual samples, its likeness to a finer one, and the mean brightness of that."""
    renderer = Renderer(meshes, instances, lights)
    grade = Grade(exposure_ev=-0.5)
    large = replace(camera, width=camera.width * _FINER, height=camera.height * _FINER)
    reference = shrunk(renderer.render(large, grade=grade, samples=16).rgb, _FINER)
    before = time.process_time()
    picture = renderer.render(camera, grade=grade).rgb
    seconds = time.process_time() - before
    renderer.close()
    found = RivalTrial("ours", 4, round(seconds, 3), round(similarity(picture, developed(reference, 1.0)), 4), True)
    return found, picture, middle(reference)


def run(
    level: Path,
    out: Path,
    view: Sequence[float],
    mitsuba: str | None,
    blender: str | None,
    many: int = MANY,
    only: Sequence[str] = (),
) -> list[RivalTrial]:
    """Ours and the rivals that are installed, or those of them that are named; pictures go to ``out``."""
    from c4s.engine.headless.pictures import take
    from c4s.engine.headless.pictures.lights import lights_of

    out.mkdir(parents=True, exist_ok=True)
    camera = Camera((view[0], view[1], view[2]), (view[3], view[4], 0.0), view[5], WIDTH, HEIGHT)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        found = [one for one in rivals(mitsuba, blender, folder) if not only or one[0] in only]
        if not found:
            raise SystemExit("no rival is installed")
        boot(
            packs_of(backend("headless").asset_paths(level)),
            folder,
            levels=[level],
            start_map=Level.read(level).package,
        )
        meshes, instances = take.placed(world())
        lights = replace(lights_of(tuple(world().light_sources())), fog=None)
        hand_over(folder, meshes, instances, lights, camera)
        own, picture, mean = ours(meshes, instances, lights, camera)
        Image.fromarray(picture).save(out / "ours.png")
        trials = [own]
        for title, words in found:
            rival = Rival(title, words)
            reference, _ = rival.take(many, folder / "many.npy")
            trial, picture = fewest(
                title, own.similarity, partial(rival.take, file=folder / "few.npy"), reference, mean
            )
            rival.close()
            Image.fromarray(picture).save(out / f"{title.replace(' ', '-')}.png")
            trials.append(trial)
            print(trial, file=sys.stderr, flush=True)
    return trials


def table(trials: Sequence[RivalTrial]) -> str:
    """The result as Markdown."""
    lines = ["| Renderer | Samples a pixel | SSIM with its own reference | Processor seconds | Times ours |"]
    lines.append("|---|---|---|---|---|")
    for one in trials:
        times = f"{one.cpu_seconds / trials[0].cpu_seconds:.1f}"
        reached = "" if one.enough else " (less than ours)"
        lines.append(
            f"| {one.renderer} | {one.samples} | {one.similarity:.3f}{reached} | {one.cpu_seconds:.2f} | {times} |"
        )
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare and print the table."""
    parser = argparse.ArgumentParser(prog="python -m bench.rival_pictures", description=__doc__)
    parser.add_argument("level", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--mitsuba", help="a Python with the package mitsuba")
    parser.add_argument("--blender", default=shutil.which("blender"), help="Blender, or a Python with bpy")
    parser.add_argument("--view", default="-1200,-1200,700,-20,45,60", help="X,Y,Z cm, PITCH, YAW, FOV degrees")
    parser.add_argument("--many", type=int, default=MANY, help="samples a pixel of a rival's own reference")
    parser.add_argument("--only", nargs="+", default=[], help="rivals by name")
    given = parser.parse_args(arguments)
    view = [float(part) for part in given.view.split(",")]
    if len(view) != 6:
        parser.error("--view takes six numbers")
    print(table(run(given.level, given.out, view, given.mitsuba, given.blender, given.many, given.only)))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
