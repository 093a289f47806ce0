"""Compares the figure's view from the eye with the certified picture of `raycheck image`."""
from pages import PageTest, ran, said, temporary

BACKGROUND = (16, 18, 24)  # of a pixel without a sphere
MOST_DIFFERING = 0.05  # of the pixels at outlines


def certified(scene, width, height, rows, sphere_colours):
    """The nearest sphere of each pixel, -1 for background, as `raycheck image` paints it; in rows, j = 0 first."""
    path = temporary("certified.ppm")
    ran("image", scene, "--size", f"{width},{height}", "--out", path)
    magic, size, greatest, data = path.read_bytes().split(b"\n", 3)
    assert (magic, size, greatest) == (b"P6", b"%d %d" % (width, height), b"255"), (magic, size, greatest)
    pixels = [sphere_of(tuple(data[k:k + 3]), sphere_colours) for k in range(0, 3 * width * height, 3)]
    from_top = [pixels[row * width:(row + 1) * width] for row in range(height)]
    return from_top if rows == "top-first" else from_top[::-1]


def sphere_of(colour, sphere_colours):
    """The sphere of which a colour is a shade, or -1 for the background. Shades of one hue have the same ratios."""
    if colour == BACKGROUND:
        return -1

    def away(other):
        base = bytes.fromhex(other[1:])
        return sum(abs(a / max(colour) - b / max(base)) for a, b in zip(colour, base))

    return min(range(len(sphere_colours)), key=lambda sphere: away(sphere_colours[sphere]))


def around(i, j, width, height):
    return [(a, b) for a in range(max(i - 1, 0), min(i + 2, width)) for b in range(max(j - 1, 0), min(j + 2, height))]


# The sphere that each of width x height pixels of the view from the eye shows, or -1; row j = 0
# comes first.
DRAWN = """const [width, height] = arguments;
  const { figure } = raycheckPage.store.scene();
  const { camera, spheres } = figure;
  const axes = [camera.U, camera.V, camera.W];
  const { samples } = raycheckPage.store.scene().conventions;
  const [x0, x1, y0, y1] = camera.window;
  // Of samples at edges half a cell is beside them, and cells are smaller where there are more.
  const scaled = (low, high, own, now) => {
    const half = (high - low) / 2 * (samples === "edges" ? (1 - 1 / own) / (1 - 1 / now) : 1);
    return [(low + high) / 2 - half, (low + high) / 2 + half];
  };
  const window = [...scaled(x0, x1, camera.width, width), ...scaled(y0, y1, camera.height, height)];
  const painter = raycheckPage.webglPainter(document.createElement("canvas"), { IDENTIFY: 1 });
  const list = { camera, axes, palette: { rim: "#000000" }, segments: [], points: [], spheres: spheres.centre.map((centre, index) =>
    ({ index, centre, radius: spheres.radius[index], colour: "#000000" })) };
  painter.stage.remove(...painter.stage.children.slice(1)); // all but the spheres
  painter.paint(list, { viewer: raycheckPage.eyeViewer({ ...camera, window }), width, height }, 1);
  const context = painter.renderer.getContext();
  const bytes = new Uint8Array(4 * width * height);
  context.readPixels(0, 0, width, height, context.RGBA, context.UNSIGNED_BYTE, bytes);
  painter.renderer.forceContextLoss();
  const row = (j) => (camera.rows === "top-first" ? height - 1 - j : j);
  return Array.from({ length: width * height }, (_, k) => 4 * (row(Math.floor(k / width)) * width + k % width))
    .map((k) => bytes[k] + 256 * bytes[k + 1] + 65536 * bytes[k + 2] - 1);"""


class EyeTest(PageTest):
    def check_eye(self, scene, width, height):
        """Checks the open page's view from the eye with this number of pixels, as if the scene had them. It differs from the
        certified picture only at outlines or beside them, and only at few of these."""
        rows, colours = self.run_script("""const { camera, spheres } = raycheckPage.store.scene().figure;
          return [camera.rows, spheres.colour];""")
        drawn = self.run_script(DRAWN, width, height)
        seen = certified(scene, width, height, rows, colours)
        self.assertEqual(len(drawn), width * height)
        outlines = differing = 0
        for k, sphere in enumerate(drawn):
            i, j = k % width, k // width
            is_outline = len({seen[b][a] for a, b in around(i, j, width, height)}) > 1
            outlines += is_outline
            if sphere != seen[j][i]:
                differing += 1
                self.assertTrue(is_outline, f"pixel ({i}, {j}): drawn {sphere}, certified {seen[j][i]}, no outline near")
        count = len({sphere for row in seen for sphere in row} - {-1})
        said(f"  from the eye: {count} spheres, {differing} of {width * height} pixels differ, {outlines} are at outlines")
        self.assertLessEqual(differing, MOST_DIFFERING * outlines)
        return count

    def check_seen(self, scene):
        """The nearest spheres in the page are those of `raycheck image`."""
        camera, runs, colours = self.run_script("""const { figure, seen } = raycheckPage.store.scene();
          return [figure.camera, seen, figure.spheres.colour];""")
        shown = certified(scene, camera["width"], camera["height"], camera["rows"], colours)
        self.assertEqual([sphere for length, sphere in runs for _ in range(length)], [sphere for row in shown for sphere in row])
