"""Cycles of Blender (Debian: blender) on processors: blender --python blender-points.py -- NFF IMAGE. Its analytic spheres are
the points of point clouds, which geometry nodes make of vertices; its UV spheres are meshes, and are not judged. Points
do not show their insides. A pixel's sample is at a random place in it. Source: manual 3.4, Point Cloud, Mesh to Points, Camera (Lens), Cycles (Render Settings)."""
import math
import os
import sys

import bpy
import mathutils

sys.path.insert(0, os.path.dirname(__file__))
from pictures import leave_out_from_inside, read

path, image = sys.argv[sys.argv.index("--") + 1:]
it = read(path)
if min(it.width, it.height) < 4:  # the smallest picture
    sys.exit(77)
leave_out_from_inside(it)
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def glowing(colour):
    material = bpy.data.materials.new("glowing")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    glow, out = tree.nodes.new("ShaderNodeEmission"), tree.nodes.new("ShaderNodeOutputMaterial")
    glow.inputs["Color"].default_value = (*colour, 1)
    tree.links.new(glow.outputs[0], out.inputs["Surface"])
    return material


def add_sphere(centre, radius, colour):
    mesh = bpy.data.meshes.new("vertex")
    mesh.from_pydata([centre], [], [])
    sphere = bpy.data.objects.new("sphere", mesh)
    scene.collection.objects.link(sphere)
    tree = bpy.data.node_groups.new("points", "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Geometry")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    start, points, painted, end = (tree.nodes.new(kind) for kind in (
        "NodeGroupInput", "GeometryNodeMeshToPoints", "GeometryNodeSetMaterial", "NodeGroupOutput"))
    for one, other in ((start, points), (points, painted), (painted, end)):
        tree.links.new(one.outputs[0], other.inputs[0])
    points.inputs["Radius"].default_value = radius
    painted.inputs["Material"].default_value = glowing(colour)
    sphere.modifiers.new("points", "NODES").node_group = tree


for x, y, z, radius, *colour in it.spheres:
    add_sphere((x, y, z), radius, colour)
lens = bpy.data.cameras.new("camera")
lens.sensor_fit, lens.angle = "HORIZONTAL", 2 * math.atan(it.right)
lens.clip_start, lens.clip_end = 1e-3, 1e6
scene.camera = bpy.data.objects.new("camera", lens)
scene.camera.matrix_world = mathutils.Matrix([*((*row, place) for row, place in zip(zip(it.U, it.V, it.W), it.eye)), (0, 0, 0, 1)])
scene.render.engine = "CYCLES"
scene.cycles.samples, scene.cycles.use_adaptive_sampling, scene.cycles.use_denoising = 1, False, False
scene.cycles.pixel_filter_type = "BOX"
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = it.width, it.height, 100
scene.render.threads_mode, scene.render.threads = "FIXED", 1
scene.view_settings.view_transform, scene.render.dither_intensity = "Standard", 0
scene.render.image_settings.file_format = "PNG"
scene.render.filepath = os.path.abspath(image)
bpy.ops.render.render(write_still=True)
