"""Writers of picture formats, in the simplest way that each allows."""
import math
import struct
import subprocess


def bmp(lines):
    pad = bytes(-3 * len(lines[0]) % 4)
    rows = b"".join(b"".join(bytes(pixel[::-1]) for pixel in line) + pad for line in lines[::-1])
    return b"BM" + struct.pack("<IHHIIiiHHIIiiII", 54 + len(rows), 0, 0, 54, 40, len(lines[0]), len(lines), 1, 24, 0,
                               len(rows), 2835, 2835, 0, 0) + rows


def tga(lines):
    rows = b"".join(bytes(pixel[::-1]) for line in lines[::-1] for pixel in line)
    return struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, len(lines[0]), len(lines), 24, 0) + rows


def pfm(lines):
    rows = b"".join(struct.pack("<3f", *(c / 255 for c in pixel)) for line in lines[::-1] for pixel in line)
    return b"PF\n%d %d\n-1.0\n" % (len(lines[0]), len(lines)) + rows


def hdr(lines, *options):
    """With an option: the last row first."""
    def rgbe(pixel):
        _, exponent = math.frexp(max(pixel) / 255)
        return bytes([*(int(c / 255 * 256 / 2**exponent) for c in pixel), exponent + 128]) if any(pixel) else bytes(4)
    rows = b"".join(rgbe(pixel) for line in (lines[::-1] if options else lines) for pixel in line)
    order = b"%sY %d +X %d\n" % (b"+" if options else b"-", len(lines), len(lines[0]))
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + order + rows


def exr(lines):
    """One part, not compressed, three channels of floats."""
    window = struct.pack("<4i", 0, 0, len(lines[0]) - 1, len(lines) - 1)
    channels = b"".join(name + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    header = b"\x76\x2f\x31\x01\2\0\0\0"
    for name, kind, value in ((b"channels", b"chlist", channels), (b"compression", b"compression", b"\0"),
                              (b"dataWindow", b"box2i", window), (b"displayWindow", b"box2i", window),
                              (b"lineOrder", b"lineOrder", b"\0"), (b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
                              (b"screenWindowCenter", b"v2f", bytes(8)),
                              (b"screenWindowWidth", b"float", struct.pack("<f", 1))):
        header += name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value
    rows = [b"".join(struct.pack("<f", pixel[k] / 255) for k in (2, 1, 0) for pixel in line) for line in lines]
    first, size = len(header) + 1 + 8 * len(rows), 8 + len(rows[0])
    return (header + b"\0" + b"".join(struct.pack("<Q", first + k * size) for k in range(len(rows))) +
            b"".join(struct.pack("<ii", y, len(row)) + row for y, row in enumerate(rows)))


def jpeg(lines, *options):
    ppm = b"P6 %d %d 255\n" % (len(lines[0]), len(lines)) + bytes(c for line in lines for pixel in line for c in pixel)
    return subprocess.run(["convert", "ppm:-", *options, "jpeg:-"], input=ppm, stdout=subprocess.PIPE, check=True).stdout


def write(lines, name, *options):
    """Lines of pixels of three bytes, the top line first, in the format that the name's ending says."""
    ending = name.rsplit(".", 1)[1]
    with open(name, "wb") as file:
        file.write(globals()["jpeg" if ending == "jpg" else ending](lines, *options))
