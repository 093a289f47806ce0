"""The view from the eye, as the figure draws it, beside the certified picture."""
from pages import PageTest, ran, said, temporary


def neighbours(i, j, width, height):
    return [(i + a, j + b) for a in (-1, 0, 1) for b in (-1, 0, 1) if 0 <= i + a < width and 0 <= j + b < height]


def class_picture(scene):
    """Whether pixel (i, j) sees a sphere, as `raycheck image` has it: rows from the picture's top."""
    path = temporary("class.ppm")
    ran("image", scene, "--what", "class", "--out", path)
    data = path.read_bytes()
    magic, size, greatest, pixels = data.split(b"\n", 3)
    assert (magic, greatest) == (b"P6", b"255"), data[:20]
    width, height = map(int, size.split())
    colours = [pixels[k:k + 3] for k in range(0, 3 * width * height, 3)]
    return [colours[row * width:(row + 1) * width] for row in range(height)]


class EyeTest(PageTest):
    def check_eye(self, scene):
        """Every pixel where the figure differs from the certified picture has, there or beside it, two
        spheres, or a sphere and none: an outline. Returns how many differ."""
        width, height, rows, runs, drawn = self.run_script("""const { figure: { camera }, seen } = raycheckPage.store.scene();
          return [camera.width, camera.height, camera.rows, seen, Array.from(raycheckPage.eyePicture())];""")
        seen = [sphere for length, sphere in runs for _ in range(length)]
        self.assertEqual((len(seen), len(drawn)), (width * height, width * height))
        self.check_certified(seen, class_picture(scene), width, height, rows)
        differing = [k for k in range(width * height) if seen[k] != drawn[k]]
        for k in differing:
            i, j = k % width, k // width
            around = {seen[b * width + a] for a, b in neighbours(i, j, width, height)}
            self.assertGreater(len(around), 1, f"pixel ({i}, {j}): drawn {drawn[k]}, certified {seen[k]}, no outline near")
        said(f"  from the eye: {len(differing)} of {width * height} pixels differ, {len(set(seen) - {-1})} spheres seen")
        return len(differing)

    def check_certified(self, seen, colours, width, height, rows):
        """The page's certified picture is that of `raycheck image`, the same way up."""
        told = {}
        for j in range(height):
            row = colours[j if rows == "top-first" else height - 1 - j]
            for i in range(width):
                is_seen = seen[j * width + i] >= 0
                self.assertEqual(told.setdefault(row[i], is_seen), is_seen, f"pixel ({i}, {j})")
        self.assertLessEqual(len(told), 2)
