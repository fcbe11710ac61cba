# Run by the module's test in MicroPython's QEMU port: scenes lie in memory where the test's script says, frames of theirs
# are printed as digests, which the script compares with those of `zstrip render`. Names in capitals are the script's; with
# NATIVE, the address and size of an .mpy file, that is the module.
import binascii
import gc
import hashlib
import io
import machine
import sys
import uctypes


class File(io.IOBase):
    """The native module, which is read once."""

    at = 0

    def ioctl(self, request, argument):
        return 0

    def readinto(self, buffer):
        count = min(len(buffer), NATIVE[1] - self.at)
        buffer[:count] = uctypes.bytearray_at(NATIVE[0] + self.at, count)
        self.at += count
        return count


class FileSystem:
    def mount(self, readonly, mkfs):
        pass

    def stat(self, path):
        if path != "/native.mpy":
            raise OSError(2)
        return (0x8000,) + (0,) * 9

    def open(self, path, mode):
        return File()


if NATIVE:
    import vfs

    vfs.mount(FileSystem(), "/memory")
    sys.path.insert(0, "/memory")
    gc.collect()
    free = gc.mem_free()
    import native as zstrip

    gc.collect()
    print("RAM of the module", free - gc.mem_free())
else:
    import zstrip


def scene(name):
    address, size = SCENES[name]
    return uctypes.bytearray_at(address, size)


def fails(words, function, *arguments):
    try:
        function(*arguments)
    except ValueError as error:
        if words in str(error):
            return
        print("wrong error:", error)
    else:
        print("no error:", words)


def show(name, frames, clip=None):
    player.open(scene(name))
    player.fit(160, 120)
    if clip is not None:
        player.play_clip(clip)
    for frame in range(frames):
        player.seek(player.period() * frame // frames)
        digest = hashlib.sha256()
        player.draw(lambda left, top, width, height, pixels: digest.update(pixels))
        print("frame", name, frame, binascii.hexlify(digest.digest()).decode())


fails("too little", zstrip.Player, 16)
player = zstrip.Player(40000)
fails("open", player.begin)
fails("no whole scene", player.open, b"no scene")
show("teapot", 4)
show("room", 4)
show("figure", 3, "wave")
print("clips", player.clips())
fails("clip", player.play_clip, "run")
fails("format", player.fit, 160, 120, 7)
for name in ("rows", "row_step"):
    for number in (-1, 65536):  # their lowest 16 bits are other numbers
        fails("between 0 and 65535", lambda: player.fit(160, 120, **{name: number}))

player.open(scene("events"))
player.fit(160, 120)
events = []
for now in (0, 1200, 2300):
    player.play(now)
    while (number := player.poll_event()) is not None:
        events.append((now, number))
print("events", events)

player.open(scene("room"))
fails("fit", player.strip, 0)
player.fit(160, 120, rows=16, masked=True)
print("picked", player.pick(80, 60))
picture = bytearray(2 * 160 * 120)
player.draw_into(picture)
left, top, width, height, pixels, mask = player.strip(40)
same = bytes(pixels) == bytes(picture[2 * 160 * top : 2 * 160 * (top + height)])
print("strip", left, width, top <= 40 < top + height, same, len(mask) == width * height)
fails("bytes", player.draw_into, bytearray(100))
print("changed", player.changed(), player.changed())
player.orbit(-4096, 1000)
player.zoom(120)
player.background(0x102030)
player.text("hello")
before = hashlib.sha256(picture).digest()
player.draw_into(picture)
print("turned", hashlib.sha256(picture).digest() != before)
player.orbit(0, 0)
player.zoom(100)
player.background(None)
player.text("")
player.draw_into(picture)
print("turned back", hashlib.sha256(picture).digest() == before)

# A strip keeps the memory of its player, which the collector would give to others.
view = player.strip(40)[4]
kept = bytes(view)
player = None
gc.collect()
rest = []
try:
    while True:
        rest.append(bytearray(b"\xa5" * 256))
except MemoryError:
    rest = None
print("kept", bytes(view) == kept)
print("end")
machine.reset()  # ends QEMU
