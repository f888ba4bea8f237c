"""Checks the committed models and textures with readers that are not ours: python tests/files/second_reader.py.

Needs trimesh and Pillow (see requirements.txt beside this file); .ci/run calls it in an environment of its own.
"""

import pathlib
import sys

import numpy
import trimesh
from PIL import Image

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "assets"

# Name, smallest and largest number of triangles, number of closed bodies.
MODELS = [
    ("sphere.obj", 5000, 5000, 1),
    ("cube.obj", 12, 12, 1),
    ("torus-knot.obj", 5760, 5760, 1),
    ("head.obj", 2500, 6000, 3),
    ("head-low.obj", 638, 638, 3),
]

# Name, side and mode of the textures.
TEXTURES = [
    ("head.tga", 1024, "RGB"),
    ("crate.png", 256, "RGB"),
    ("head-normals.png", 1024, "RGB"),
    ("head-tangents.png", 1024, "RGB"),
    ("head-low-tangents.png", 1024, "RGB"),
    ("head-shine.png", 512, "L"),
]


def faults(name, least, most, bodies):
    """What is wrong with a model, a line each."""
    # One vertex for each corner that differs in position, texture coordinate or normal.
    read = trimesh.load(FOLDER / name, process=False)
    joined = trimesh.Trimesh(read.vertices, read.faces, process=False)
    joined.merge_vertices(merge_tex=True, merge_norm=True, digits_vertex=5)
    lengths = numpy.linalg.norm(read.vertex_normals, axis=1)
    towards = numpy.einsum("ij,ij->i", read.face_normals, read.vertex_normals[read.faces].sum(axis=1))
    corners = numpy.sort(joined.faces, axis=1)
    tests = {
        f"{len(read.faces)} triangles": least <= len(read.faces) <= most,
        "outside [-1, 1]": numpy.abs(read.vertices).max() <= 1,
        "a normal is not of unit length": numpy.abs(lengths - 1).max() < 1e-3,
        "a texture coordinate is outside [0, 1]": read.visual.uv.min() >= 0 and read.visual.uv.max() <= 1,
        "a triangle has no area": read.area_faces.min() > 0,
        "a face uses a corner twice": (corners[:, 1:] != corners[:, :-1]).all(),
        "a triangle faces away from its normals": (towards > 0).all(),
        "not closed": joined.is_watertight,
        "neighbours wind in opposite directions": joined.is_winding_consistent,
        "not the number of bodies": joined.body_count == bodies,
        "inside out": all(body.volume > 0 for body in joined.split()),
    }
    return [f"{name}: {fault}" for fault, passed in tests.items() if not passed]


def texture_faults(name, side, mode):
    """What is wrong with a texture, a line each."""
    # Loading fails where the file's pixels are not all there.
    picture = Image.open(FOLDER / name)
    picture.load()
    tests = {
        f"{picture.size} pixels": picture.size == (side, side),
        f"{picture.mode} pixels": picture.mode == mode,
        "of one colour": len(set(picture.resize((64, 64)).get_flattened_data())) > (100 if mode == "RGB" else 20),
    }
    return [f"{name}: {fault}" for fault, passed in tests.items() if not passed]


if __name__ == "__main__":
    found = [fault for model in MODELS for fault in faults(*model)]
    found += [fault for texture in TEXTURES for fault in texture_faults(*texture)]
    print("\n".join(found) or f"{len(MODELS)} models and {len(TEXTURES)} textures read, nothing wrong")
    sys.exit(bool(found))
