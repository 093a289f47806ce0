import math
import raycheck_candidate as rc


class V:
    def __init__(self, x, y, z):
        self.x, self.y, self.z = x, y, z

    def __add__(self, o): return V(self.x + o.x, self.y + o.y, self.z + o.z)
    def __sub__(self, o): return V(self.x - o.x, self.y - o.y, self.z - o.z)
    def __mul__(self, k): return V(self.x * k, self.y * k, self.z * k)
    def __matmul__(self, o): return self.x * o.x + self.y * o.y + self.z * o.z
    def __len__(self): return 3
    def __getitem__(self, k): return (self.x, self.y, self.z)[k]

    def cross(self, o):
        return V(self.y * o.z - self.z * o.y, self.z * o.x - self.x * o.z, self.x * o.y - self.y * o.x)

    def length(self):
        return math.sqrt(self @ self)

    def unit(self):
        n = self.length()
        return V(self.x / n, self.y / n, self.z / n)


def frame(camera):
    w = (V(*camera.eye) - V(*camera.look_at)).unit()
    u = V(*camera.up).cross(w).unit()
    return [tuple(axis) for axis in (u, w.cross(u), w)]


def arrow(camera, pixel):
    """from the eye to the pixel"""
    i, j = pixel
    u, v, w = [V(*axis) for axis in frame(camera)]
    alpha = camera.left + i * (camera.right - camera.left) / (camera.width - 1)
    beta = camera.bottom + j * (camera.top - camera.bottom) / (camera.height - 1)
    return w * camera.near + u * alpha + v * beta


def pixel_point(camera, conventions, pixel):
    return tuple(V(*camera.eye) + arrow(camera, pixel))


def pixel_ray(camera, conventions, pixel):
    return pixel_point(camera, conventions, pixel), tuple(arrow(camera, pixel))


def intersect(ray, sphere, conventions):
    start, way = V(*ray[0]), V(*ray[1])
    t = V(*sphere[0]) - start
    a = way @ way
    v = (t @ way) / a
    aside = t - way * v
    square = (sphere[1] ** 2 - aside @ aside) / a
    if square < 0:
        return None
    s = v - math.sqrt(square)
    if s < 0:
        s = v + math.sqrt(square)
    return (s, tuple(start + way * s)) if s >= 0 else None


def nearest(ray, spheres, conventions):
    found = {}
    for k, sphere in enumerate(spheres):
        hit = intersect(ray, sphere, conventions)
        if hit:
            found[k] = hit[0]
    return min(found, key=found.get) if found else None


rc.run("mira", frame=frame, pixel_point=pixel_point, pixel_ray=pixel_ray, intersect=intersect, nearest=nearest)
