"""What scripts/mutants.py does to a good file to make it a hostile one.

`mutate` knows what each format is made of: a byte flipped anywhere mostly ends in a syntax error at
the first check, so that most changes are made where a file still parses, or where a checksum is put
right again. Each is a function of the content and of `random` alone.
"""

import base64
import copy
import json
import math
import re
import struct
import zlib

NUMBERS = (
    "0 -0.0 1 -1 2 3 7 255 256 65535 65536 2147483647 -2147483648 4294967295 4294967296 "
    "9007199254740993 18446744073709551616 0.5 1e-320 1e-46 1e-20 1e6 1e20 3.4e38 3.5e38 -1e38 "
    "1e308 1e999 -1e999 NaN inf -nan 1e --1 0x10 00 1.2.3"
).split()
# Of 32 bits: ends of the ranges of whole numbers; floats that are least, greatest, infinite, none.
FIELDS = (
    0, 1, 2, 3, 0x7F, 0xFF, 0x100, 0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF,
    0x00800000, 0x3F800000, 0x7149F2CA, 0x7F7FFFFF, 0x7F800000, 0xFF800000, 0x7FC00000,
)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
# Where a file is not what its suffix says, or no longer.
CANNOT = (ValueError, LookupError, TypeError, ArithmeticError, RecursionError, AttributeError,
          struct.error, zlib.error)
DEEP = 3000  # brackets in brackets
LONG = 70000  # letters of a long word: more than 16 bits count


# ---- bytes ------------------------------------------------------------------------------------


def span(data, random):
    """A piece of the data, mostly a short one: (start, end)."""
    start = random.randrange(len(data) + 1)
    return start, min(len(data), start + int(2 ** random.uniform(0, 12)))


def change_bytes(data, random):
    data = bytearray(data)
    start, end = span(data, random)
    other, other_end = span(data, random)
    kind = random.choice(("flip", "set", "delete", "repeat", "copy", "swap", "cut", "empty"))
    if kind == "flip" and data:
        data[random.randrange(len(data))] ^= 1 << random.randrange(8)
    elif kind == "set" and data:
        data[random.randrange(len(data))] = random.randrange(256)
    elif kind == "delete":
        del data[start:end]
    elif kind == "repeat":
        data[start:start] = data[start:end] * random.choice((1, 1, 2, 50))
    elif kind == "copy":
        data[start:start] = data[other:other_end]
    elif kind == "swap" and end <= other:
        data[start:other_end] = data[other:other_end] + data[end:other] + data[start:end]
    elif kind == "cut":
        del data[start:]
    elif kind == "empty":
        data[start:end] = bytes(end - start)
    return bytes(data)


def change_fields(data, random, reach=None):
    """Numbers of one, two or four bytes, of either order, get telling values."""
    data = bytearray(data)
    for _ in range(random.choice((1, 1, 2, 8))):
        size = random.choice((1, 2, 4, 4, 4))
        places = min(len(data), reach or len(data)) // size
        if places > 0:
            at = size * random.randrange(places)
            value = random.choice(FIELDS) & (256**size - 1)
            data[at : at + size] = value.to_bytes(size, random.choice(("little", "little", "big")))
    return bytes(data)


# ---- text -------------------------------------------------------------------------------------


def change_text(data, random):
    text = data.decode("latin-1")
    lines = text.split("\n")
    line = random.randrange(len(lines))
    words = lines[line].split(" ")
    word = random.randrange(len(words))
    kind = random.choice(("number",) * 6 + ("drop", "double", "swap", "word", "long", "lines"))
    if kind == "number":
        found = list(NUMBER.finditer(text))
        if found:
            place = random.choice(found)
            near = str(int(float(place[0])) + random.choice((-1, 1))) if len(place[0]) < 9 else "0"
            number = random.choice(NUMBERS + [near] * 8)
            return (text[: place.start()] + number + text[place.end() :]).encode("latin-1")
    elif kind == "drop":
        del words[word]
    elif kind == "double":
        words[word:word] = [words[word]] * random.choice((1, 2, 5000))
    elif kind == "word":
        words[word] = random.choice(random.choice(lines).split(" "))
    elif kind == "long":
        words[word] = random.choice(("x", "/", "9", "\0", "\xff", '"')) * LONG
    lines[line] = " ".join(words)
    if kind == "swap":
        other = random.randrange(len(lines))
        lines[line], lines[other] = lines[other], lines[line]
    elif kind == "lines":
        lines[line : line + 1] = [lines[line]] * random.choice((0, 2, 1000))
    return "\n".join(lines).encode("latin-1")


# ---- JSON -------------------------------------------------------------------------------------


def place_in(document, random):
    """A place that is likely for every key, however many numbers the file's lists have."""
    container = document
    while True:
        keys = list(container) if isinstance(container, dict) else range(len(container))
        key = random.choice(keys)
        inner = container[key]
        if not isinstance(inner, (dict, list)) or not inner or random.random() < 0.15:
            return container, key
        container = inner


def raw(text):
    """A string that json_text writes without quotes."""
    return "\ue000" + text


def json_text(document):
    text = json.dumps(document, ensure_ascii=False, separators=(",", ":"))
    return re.sub('"\ue000([^"]*)"', r"\1", text).encode("utf-8", "surrogatepass")


def changed_value(value, document, random):
    if isinstance(value, (int, float)) and random.random() < 0.8:
        if not math.isfinite(value):
            return 0
        whole = int(value)
        near = [value + 1, value - 1, value * 2, whole + random.randrange(-3, 4), whole ^ 1]
        return random.choice(near) if random.random() < 0.6 else raw(random.choice(NUMBERS))
    if isinstance(value, str) and random.random() < 0.8:
        words = [value[: len(value) // 2], value + "x", "../" + value, "x" * LONG, "\0", "data:,"]
        container, key = place_in(document, random)
        return random.choice(words + [copy.deepcopy(container[key])] * 4)
    if isinstance(value, list) and value and random.random() < 0.6:
        return random.choice((value[1:], value * 2, value[:1] * 5000, value[::-1]))
    brackets = random.choice(("[]", '{"a":}')).partition(":")
    deep = ("[" * DEEP + "]" * DEEP) if not brackets[1] else ('{"a":' * DEEP + "0" + "}" * DEEP)
    return random.choice(([], {}, None, "", True, -1, [value], {"index": value}, [[]], raw(deep)))


def change_json(data, random):
    document = json.loads(data)
    for _ in range(random.choice((1, 1, 1, 2))):
        container, key = place_in(document, random)
        kind = random.choice(("value",) * 6 + ("remove", "rename", "swap"))
        if kind == "remove":
            del container[key]
        elif kind == "rename" and isinstance(container, dict):
            other, other_key = place_in(document, random)
            container[str(other_key)] = container.pop(key)
        elif kind == "swap":
            other, other_key = place_in(document, random)
            container[key] = copy.deepcopy(other[other_key])
        else:
            container[key] = changed_value(container[key], document, random)
    return json_text(document)


def change_data_uri(data, random):
    """The bytes within a data URI, as far as there is one."""
    found = list(re.finditer(rb'base64,([A-Za-z0-9+/=]+)"', data))
    if not found:
        return change_json(data, random)
    place = random.choice(found)
    changed = base64.b64encode(change_payload(base64.b64decode(place[1]), random))
    return data[: place.start(1)] + changed + data[place.end(1) :]


# ---- GLB --------------------------------------------------------------------------------------


def glb_chunks(data):
    """[type, content] of each chunk, or None where the file is no whole GLB."""
    chunks, at = [], 12
    while at + 8 <= len(data):
        size, kind = struct.unpack_from("<II", data, at)
        chunks.append([kind, data[at + 8 : at + 8 + size]])
        at += 8 + size
    return chunks if len(chunks) >= 2 and chunks[0][0] == 0x4E4F534A else None


def glb(chunks):
    body = b""
    for kind, content in chunks:
        content += (b" " if kind == 0x4E4F534A else b"\0") * (-len(content) % 4)
        body += struct.pack("<II", len(content), kind) + content
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def change_view(chunks, random):
    """What one buffer view holds, an image's for choice, goes to the end of the binary chunk."""
    document = json.loads(chunks[0][1])
    views = document["bufferViews"]
    images = [i["bufferView"] for i in document.get("images", []) if "bufferView" in i]
    number = random.choice(images) if images else 0
    if random.random() < 0.4:
        number = random.randrange(len(views))
    view, binary = views[number], chunks[1][1]
    for place in (view, *view.get("extensions", {}).values()):
        if "byteLength" in place:
            view = place  # the compressed bytes, where they are
    start = view.get("byteOffset", 0)
    content = change_payload(binary[start : start + view["byteLength"]], random)
    binary += b"\0" * (-len(binary) % 4)
    view["byteOffset"], view["byteLength"] = len(binary), len(content)
    chunks[1][1] = binary + content
    document["buffers"][0]["byteLength"] = len(binary + content)
    chunks[0][1] = json_text(document)


def change_glb(data, random):
    chunks = glb_chunks(data)
    kind = random.choice(("header", "chunks", "binary") + ("view",) * 3 + ("json",) * 4)
    if chunks is None or kind == "header":
        return change_fields(data, random, reach=28)
    if kind == "chunks":
        i, j = random.randrange(len(chunks)), random.randrange(len(chunks))
        chunks[i], chunks[j] = chunks[j], chunks[i]
        chunks += random.choice(([], chunks[:1], chunks[1:]))
    elif kind == "binary":
        chunks[1][1] = change_payload(chunks[1][1], random)
    elif kind == "json":
        chunks[0][1] = change_json(chunks[0][1], random)
    else:
        change_view(chunks, random)
    return glb(chunks)


# ---- images -----------------------------------------------------------------------------------


def png_chunks(data):
    chunks, at = [], 8
    while at + 12 <= len(data):
        (size,) = struct.unpack_from(">I", data, at)
        chunks.append([data[at + 4 : at + 8], data[at + 8 : at + 8 + size]])
        at += 12 + size
    return chunks


def change_pieces(pieces, random):
    """Pieces are [name, content]; one of them changes, or goes, or comes twice, or elsewhere."""
    i, j = random.randrange(len(pieces)), random.randrange(len(pieces))
    kind = random.choice(("fields", "fields", "bytes", "drop", "double", "swap"))
    if kind == "fields":
        pieces[i][1] = change_fields(pieces[i][1], random)
    elif kind == "bytes":
        pieces[i][1] = change_bytes(pieces[i][1], random)
    elif kind == "drop":
        del pieces[i]
    elif kind == "double":
        pieces.insert(j, pieces[i])
    else:
        pieces[i], pieces[j] = pieces[j], pieces[i]


def change_png(data, random):
    """With lengths and check sums put right, and sometimes within what is deflated."""
    chunks = png_chunks(data)
    if random.random() < 0.3:
        rows = zlib.decompress(b"".join(c for name, c in chunks if name == b"IDAT"))
        first = [name for name, _ in chunks].index(b"IDAT")
        chunks = [chunk for chunk in chunks if chunk[0] != b"IDAT"]
        rows = random.choice((change_bytes, change_fields))(rows, random)
        chunks.insert(first, [b"IDAT", zlib.compress(rows)])
    else:
        change_pieces(chunks, random)
    text = data[:8]
    for name, content in chunks:
        text += struct.pack(">I", len(content)) + name + content
        text += struct.pack(">I", zlib.crc32(name + content))
    return text


def change_jpeg(data, random):
    """By the segments up to the first scan; what follows is the last of them."""
    segments, at = [], 2
    while at + 4 <= len(data) and data[at] == 0xFF and data[at + 1] != 0xDA:
        (size,) = struct.unpack_from(">H", data, at + 2)
        segments.append([data[at : at + 2], data[at + 4 : at + 2 + size]])
        at += 2 + size
    if not segments or random.random() < 0.3:
        return data[:at] + change_bytes(data[at:], random)
    change_pieces(segments, random)
    text = data[:2]
    for name, content in segments:
        text += name + struct.pack(">H", min(len(content) + 2, 65535)) + content
    return text + data[at:]


# ---- by format --------------------------------------------------------------------------------


def change_payload(data, random):
    """Bytes of a buffer: an image, or anything."""
    if random.random() < 0.8:
        if data.startswith(b"\x89PNG"):
            return change_png(data, random)
        if data.startswith(b"\xff\xd8"):
            return change_jpeg(data, random)
    return random.choice((change_bytes, change_fields))(data, random)


def change_ply(data, random):
    """The header is text whatever follows."""
    head, mark, body = data.partition(b"end_header\n")
    if random.random() < 0.6:
        return change_text(head, random) + mark + body
    change = change_text if b"format ascii" in head else change_payload
    return head + mark + change(body, random)


def change_stl(data, random):
    if data.startswith(b"solid"):
        return change_text(data, random)
    return data[:80] + change_fields(data[80:], random, reach=random.choice((4, None)))


def change_tfx(data, random):
    return change_fields(data, random, reach=random.choice((16, 160, None)))


CHANGES = {
    ".glb": (change_glb,),
    ".gltf": (change_json, change_json, change_json, change_data_uri, change_text),
    ".obj": (change_text,),
    ".mtl": (change_text,),
    ".ply": (change_ply,),
    ".stl": (change_stl,),
    ".tfx": (change_tfx,),
    ".png": (change_png,),
    ".jpg": (change_jpeg,),
    ".jpeg": (change_jpeg,),
    ".bin": (change_payload,),
}


def mutate(suffix, data, random):
    """The content of a file with that suffix, changed in one way or a few."""
    for _ in range(random.choice((1, 1, 1, 1, 2, 3))):
        change = change_bytes if random.random() < 0.15 else random.choice(CHANGES[suffix])
        try:
            data = change(data, random)
        except CANNOT:
            data = change_bytes(data, random)
    return data
