"""Just enough PNG: 8 bits, not interlaced, grey, RGB or RGBA, read and written as rows of RGB."""
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}


def read(path):
    """(width, height, bytes of RGB)."""
    data = path.read_bytes()
    if data[:8] != SIGNATURE:
        raise ValueError(f"{path}: no PNG")
    at, packed, header = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        at += 12 + length
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
    width, height, depth, colour, _, _, interlace = header
    if depth != 8 or interlace or colour not in CHANNELS:
        raise ValueError(f"{path}: not 8 bits of grey or RGB")
    channels = CHANNELS[colour]
    flat = unfilter(zlib.decompress(packed), width * channels, height, channels)
    pick = [0, 0, 0] if channels < 3 else [0, 1, 2]
    rgb = bytearray(width * height * 3)
    for channel, source in enumerate(pick):
        rgb[channel::3] = flat[source::channels]
    return width, height, bytes(rgb)


def unfilter(raw, stride, height, step):
    flat, above = bytearray(), bytes(stride)
    for y in range(height):
        start = y * (stride + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for x in range(stride):
            left = row[x - step] if x >= step else 0
            corner = above[x - step] if x >= step else 0
            row[x] = row[x] + predict(kind, left, above[x], corner) & 255
        flat += row
        above = row
    return flat


def predict(kind, left, up, corner):
    if kind == 0:
        return 0
    if kind == 1:
        return left
    if kind == 2:
        return up
    if kind == 3:
        return (left + up) // 2
    estimate = left + up - corner
    return min((abs(estimate - left), 0, left), (abs(estimate - up), 1, up), (abs(estimate - corner), 2, corner))[2]


def write(path, width, height, rgb):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    rows = b"".join(b"\0" + rgb[y * width * 3:(y + 1) * width * 3] for y in range(height))
    path.write_bytes(SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
