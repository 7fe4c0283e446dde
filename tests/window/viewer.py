"""gnomon view as a process: started, watched through its status file (GNOMON_VIEW_STATUS), and used with keys and mouse."""
import json
import math
import os
import pathlib
import signal
import subprocess

from desktop import WHEEL_DOWN, WHEEL_UP
from display import end_with_parent, stop, wait_for

PROGRAM = os.path.abspath(os.environ.get("GNOMON", "build/release/bin/gnomon"))
LEFT, MIDDLE, RIGHT = 1, 2, 3


def part(picture, left, top, right, bottom):
    """A rectangle of a picture."""
    width, _, data = picture
    rows = [data[3 * (y * width + left):3 * (y * width + right)] for y in range(top, bottom)]
    return right - left, bottom - top, b"".join(rows)


def difference(one, other):
    """Root mean square over all channels of two pictures (width, height, RGB), in parts of 255."""
    if one[:2] != other[:2]:
        raise AssertionError(f"pictures of different sizes: {one[0]}x{one[1]} and {other[0]}x{other[1]}")
    return math.sqrt(sum((a - b) ** 2 for a, b in zip(one[2], other[2])) / len(one[2]))


class Viewer:
    """Files of the run - stdout, stderr, status.json, pictures - are in `folder`."""

    def __init__(self, display, desktop, folder, *arguments, environment=None, runs_in=None):
        self.desktop, self.folder = desktop, pathlib.Path(folder)
        self.status_path = self.folder / "status.json"
        self.status_path.unlink(missing_ok=True)
        self.command = [PROGRAM, "view", *map(str, arguments)]
        # The user's list of recent files is not touched.
        own = {"GNOMON_VIEW_STATUS": str(self.status_path), "XDG_STATE_HOME": str(self.folder / "state")}
        variables = {"GNOMON_VALIDATE": "1"} | display.environment() | own | (environment or {})
        with open(self.folder / "stdout", "wb") as out, open(self.folder / "stderr", "wb") as err:
            self.process = subprocess.Popen(self.command, stdout=out, stderr=err, cwd=runs_in or self.folder, env=variables,
                                            preexec_fn=end_with_parent)
        self.window = None

    # What it says.

    def stdout(self):
        return (self.folder / "stdout").read_text(encoding="utf-8")

    def stderr(self):
        return (self.folder / "stderr").read_text(encoding="utf-8")

    def status(self):
        return json.loads(self.status_path.read_text(encoding="utf-8"))

    def widgets(self):
        """Name -> [left, top, right, bottom] of what can be clicked, in pixels of the window."""
        return self.status()["widgets"]

    # Waiting.

    def wait(self, condition, text, seconds=30):
        try:
            return wait_for(condition, text, seconds, alive=[self.process])
        except AssertionError as error:
            raise AssertionError(f"{error}\n{' '.join(self.command)}\nstderr: {self.stderr()[-3000:]}") from None

    def open(self):
        """Waits for the first frame; the window then has the keyboard."""
        # A device with validation, and the scene, take a while.
        self.wait(self.status_path.is_file, "the first frame", 120)
        self.window = self.wait(lambda: self.desktop.window_of(self.process.pid), "the window")
        self.desktop.activate(self.window)
        self.wait(lambda: self.desktop.has_focus(self.window), "the keyboard focus")
        self.frames()
        return self

    def frames(self, count=2):
        """Frames that began after this call: of the next one, input may have been taken already."""
        first = self.status()["frame"]
        # Another scene counts from the beginning.
        self.wait(lambda: not first <= self.status()["frame"] < first + count, "frames")

    def until(self, condition, text, seconds=30):
        """Waits for a status for which `condition` holds. Returns it."""
        def asked():
            status = self.status()
            return status if condition(status) else None
        return self.wait(asked, f"{text}; the status is {self.status_path}", seconds)

    def until_command(self, *parts, without=(), seconds=30):
        """Waits until the command line of the picture holds each part, and none of `without`."""
        def holds(status):
            words = status["command"] + " "
            return all(f" {part} " in words for part in parts) and not any(part in words for part in without)
        return self.until(holds, f"a command with {parts}, without {without}", seconds)

    # Keys. Each is held for whole frames, since a program that asks once per frame would miss it otherwise.

    def press(self, *names):
        """Keys together: press("Control_L", "q")."""
        for name in names:
            self.desktop.key(name, True)
            self.frames()
        for name in reversed(names):
            self.desktop.key(name, False)
        self.frames()

    def type(self, text):
        """Text arrives in events of its own, of which none is lost: nothing need be held."""
        for character in text:
            keys = ["Shift_L", character] if self.desktop.needs_shift(character) else [character]
            for key in keys:
                self.desktop.key(key, True)
            for key in reversed(keys):
                self.desktop.key(key, False)
        self.frames()

    def hold(self, *names, frames=4):
        for name in names:
            self.desktop.key(name, True)
        self.frames(frames)
        for name in names:
            self.desktop.key(name, False)
        self.frames()

    # Mouse.

    def point(self, x, y):
        """Moves the pointer to a place of the window."""
        left, top = self.desktop.origin(self.window)
        self.desktop.move(left + x, top + y)
        self.frames()

    def click_at(self, x, y, button=LEFT):
        self.point(x, y)
        self.desktop.button(button, True)
        self.frames()
        self.desktop.button(button, False)
        self.frames()

    def drag(self, start, end, button=LEFT, steps=4):
        self.point(*start)
        self.desktop.button(button, True)
        self.frames()
        for step in range(1, steps + 1):
            share = step / steps
            self.point(start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1]))
        self.desktop.button(button, False)
        self.frames()

    def look(self, x, y):
        """Turns the camera: a drag with the right button, which hides and holds the pointer."""
        width, height = self.status()["window_size"]
        panel = self.widgets().get("panel", [0, 0, 0, 0])
        self.point((panel[2] + width) / 2, height / 2)
        self.desktop.button(RIGHT, True)
        self.frames(3)
        self.desktop.move_by(x, y)
        self.frames()
        self.desktop.button(RIGHT, False)
        self.frames()

    def wheel(self, notches):
        """Positive: away from the user."""
        for _ in range(abs(notches)):
            number = WHEEL_UP if notches > 0 else WHEEL_DOWN
            self.desktop.button(number, True)
            self.desktop.button(number, False)
            self.frames()

    # Widgets, by name.

    def rectangle(self, name):
        """Of a widget; it is scrolled into view where it is somewhere else in the panel or among the tools."""
        if name in self.widgets():
            return self.widgets()[name]
        for window in ("panel", "tools"):
            if name in self.widgets() or window not in self.widgets():
                continue
            left, top, right, bottom = self.widgets()[window]
            self.point((left + right) / 2, (top + bottom) / 2)
            self.scroll_to(name)
        if name not in self.widgets():
            raise AssertionError(f"no widget '{name}' on screen; there are: {', '.join(sorted(self.widgets()))}")
        return self.widgets()[name]

    def scroll_to(self, name):
        """Turns the wheel where the pointer is, up and then down, until the widget is there or nothing moves any more."""
        for notches in (2, -1):
            before = None
            while name not in self.widgets() and before != (before := self.widgets()):
                self.wheel(notches)
        self.frames()

    def middle(self, name):
        left, top, right, bottom = self.rectangle(name)
        return (left + right) / 2, (top + bottom) / 2

    def click(self, name):
        self.click_at(*self.middle(name))

    def choose(self, name, entry):
        """Opens a list and clicks on one of its entries, which need not be in view at once."""
        self.click(name)
        full = f"{name}:{entry}"
        self.entries(name)
        entry_area = next(area for other, area in self.widgets().items() if other.startswith(f"{name}:"))
        self.point((entry_area[0] + entry_area[2]) / 2, (entry_area[1] + entry_area[3]) / 2)
        self.scroll_to(full)
        if full not in self.widgets():
            raise AssertionError(f"no entry '{full}'; there are: {', '.join(sorted(self.widgets()))}")
        self.click_at(*self.middle(full))

    def entries(self, name):
        """Of an open list: those in view."""
        def listed(status):
            return [other.removeprefix(f"{name}:") for other in status["widgets"] if other.startswith(f"{name}:")]
        self.until(listed, f"the list of '{name}'")
        self.frames()  # a list has its size from its second frame on
        return listed(self.status())

    def section(self, title):
        """Opens, or closes, one of those at the right."""
        self.click(f"section:{title}")
        self.frames()  # it has its size from the second frame on

    def text(self, name):
        """What a part of the interface says, or None where it is not shown."""
        return self.status()["texts"].get(name)

    def until_text(self, name, condition, seconds=30):
        """Waits until a text is there for which `condition` holds. Returns it."""
        status = self.until(lambda status: name in status["texts"] and condition(status["texts"][name]), f"the text '{name}'", seconds)
        return status["texts"][name]

    def fill(self, name, text):
        """Replaces what is in a text field."""
        self.click(name)
        self.press("Control_L", "a")
        self.type(text)

    def double_click(self, x, y, done):
        """Until `done` holds: beside other work, frames may be longer than what counts as one double click."""
        self.point(x, y)
        for _ in range(10):
            for down in (True, False, True, False):
                self.desktop.button(LEFT, down)
                self.frames(1)
            self.frames()
            if done(self.status()):
                return
        raise AssertionError("a double click does nothing")

    def slide(self, name, share):
        """Drags a slider to a share of its way."""
        left, top, right, bottom = self.rectangle(name)
        y = (top + bottom) / 2
        self.drag(((left + right) / 2, y), (left + share * (right - left), y))

    def enter(self, name, text):
        """Control and a click make a slider a text field."""
        place = self.middle(name)
        self.point(*place)
        self.desktop.key("Control_L", True)
        self.frames()
        self.click_at(*place)
        self.desktop.key("Control_L", False)
        self.frames()
        self.type(text)
        self.press("Return")

    def search(self, text):
        """Leaves the parameters that contain a text. It replaces the one that was there."""
        self.fill("search", text)
        if not text:
            self.press("Delete")

    # The picture, and the end.

    def picture(self):
        """What the window shows: (width, height, RGB)."""
        return self.desktop.picture(self.window)

    def wait_for_end(self, seconds=60):
        """Its exit code."""
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            raise AssertionError(f"gnomon view does not end; stderr: {self.stderr()[-3000:]}") from None

    def close(self):
        """As the window's frame does it. Returns the exit code."""
        self.desktop.close(self.window)
        return self.wait_for_end()

    def interrupt(self):
        self.process.send_signal(signal.SIGINT)
        return self.wait_for_end()

    def kill(self):
        stop(self.process)
