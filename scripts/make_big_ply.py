#!/usr/bin/env python3
"""Writes a rolling field of about N triangles as a binary PLY, to see how large files are read."""

import array
import math
import sys


def main():
    if len(sys.argv) != 3 or not sys.argv[1].isdigit() or int(sys.argv[1]) < 2:
        sys.exit("usage: make_big_ply.py TRIANGLES FILE.ply")
    side = max(1, math.isqrt(int(sys.argv[1]) // 2))
    points = side + 1
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {points * points}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {2 * side * side}\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    heights = [0.02 * math.sin(0.05 * i) for i in range(points)]
    with open(sys.argv[2], "wb") as out:
        out.write(header.encode())
        for z in range(points):
            row = array.array("f")
            for x in range(points):
                row.extend((x / side - 0.5, heights[x] + heights[z], z / side - 0.5))
            out.write(row.tobytes())
        for z in range(side):
            row = bytearray()
            for x in range(side):
                a = z * points + x
                corner = (a, a + points, a + 1, a + 1, a + points, a + points + 1)
                numbers = array.array("i", corner).tobytes()
                row += b"\x03" + numbers[:12] + b"\x03" + numbers[12:]
            out.write(row)


if __name__ == "__main__":
    main()
