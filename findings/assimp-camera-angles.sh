#!/usr/bin/env bash
# Assimp's horizontal field of view depends on the file's format.
#
# Guess: aiCamera::mHorizontalFOV is what assimp/camera.h says, in radians from the centre line to
# the left or right border: 0.5236 for a camera that sees 60 degrees from left to right, whatever
# format it was read from.
#
# Happens: NFF, ASE and glTF give the full angle, 1.0472. COLLADA gives 0.0137 for every camera: the
# file's angle is not read, and the default in radians is converted from degrees once more.
#
# With: Assimp 5.2.5, Debian 12
#
# A viewer that follows the documentation shows twice the angle, and COLLADA scenes through a
# telescope of 0.8 degrees.
source "$(dirname "$0")/common.sh"
needs g++
debian_packages libassimp-dev=5.2.5~ds0-1+b1

cat >camera.cpp <<'CPP'
#include <assimp/Importer.hpp>
#include <assimp/camera.h>
#include <assimp/scene.h>
#include <cstdio>

int main(int, char** files) {
  while (*++files) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(*files, 0);
    if (!scene || scene->mNumCameras != 1) std::printf("%s: %s\n", *files, importer.GetErrorString());
    else std::printf("%s: %.4f\n", *files, scene->mCameras[0]->mHorizontalFOV);
  }
}
CPP
cat >60.nff <<'NFF'
v
from 0 0 5
at 0 0 0
up 0 1 0
angle 60
hither 1
resolution 100 100
f 1 1 1 1 0 0 0 0
s 0 0 0 1
NFF
cat >60.ase <<'ASE'
*3DSMAX_ASCIIEXPORT	200
*CAMERAOBJECT {
	*NODE_NAME "camera"
	*CAMERA_TYPE Target
	*NODE_TM {
		*NODE_NAME "camera"
	}
	*CAMERA_SETTINGS {
		*CAMERA_NEAR 1
		*CAMERA_FAR 100
		*CAMERA_FOV 1.0471976
	}
}
ASE
cat >60.gltf <<'GLTF'
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
 "nodes": [{"camera": 0}, {"mesh": 0}],
 "cameras": [{"type": "perspective",
              "perspective": {"yfov": 1.0471976, "aspectRatio": 1, "znear": 1, "zfar": 100}}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri":
   "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
GLTF
for degrees in 60 20; do
  cat >$degrees.dae <<DAE
<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><created>2020-01-01T00:00:00Z</created><modified>2020-01-01T00:00:00Z</modified></asset>
 <library_cameras><camera id="camera"><optics><technique_common><perspective>
  <xfov>$degrees</xfov><aspect_ratio>1</aspect_ratio><znear>1</znear><zfar>100</zfar>
 </perspective></technique_common></optics></camera></library_cameras>
 <library_geometries><geometry id="mesh"><mesh>
  <source id="points"><float_array id="numbers" count="9">0 0 0 1 0 0 0 1 0</float_array>
   <technique_common><accessor source="#numbers" count="3" stride="3"><param name="X" type="float"/>
    <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
  <vertices id="vertices"><input semantic="POSITION" source="#points"/></vertices>
  <triangles count="1"><input semantic="VERTEX" source="#vertices" offset="0"/><p>0 1 2</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="scene">
  <node id="eye"><instance_camera url="#camera"/></node>
  <node id="object"><instance_geometry url="#mesh"/></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
DAE
done
g++ -O1 camera.cpp -o camera -lassimp
./camera 60.nff 60.ase 60.gltf 60.dae 20.dae | tee seen
as_stated <<'SEEN'
60.nff: 1.0472
60.ase: 1.0472
60.gltf: 1.0472
60.dae: 0.0137
20.dae: 0.0137
SEEN
