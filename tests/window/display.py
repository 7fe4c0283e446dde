"""An X server without a screen, and a window manager on it: both belong to the test and end with it."""
import ctypes
import os
import pathlib
import select
import signal
import subprocess
import time

from Xlib import X
from Xlib import display as xlib

SCREEN = "1280x800x24"


def end_with_parent():
    """In a child process: it is killed when this one dies, however that happens (a test that runs too long is killed by CTest)."""
    set_death_signal = 1
    ctypes.CDLL(None).prctl(set_death_signal, signal.SIGKILL)


def stop(process, seconds=10):
    """Ends a child, by force where it does not go."""
    if process.poll() is None:
        process.terminate()
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.kill()
    process.wait()


def wait_for(condition, text, seconds=30, alive=()):
    """The first result of `condition` that is true. Fails after `seconds`, or as soon as one of the processes `alive` has ended."""
    end = time.monotonic() + seconds
    while True:
        dead = [process for process in alive if process.poll() is not None]
        result = condition()
        if result:
            return result
        if dead:
            raise AssertionError(f"waiting for {text}: {dead[0].args[0]} ended with exit code {dead[0].returncode}")
        if time.monotonic() > end:
            raise AssertionError(f"waited {seconds} s in vain for {text}")
        time.sleep(0.01)


class Display:
    """Xvfb under the first free number, and openbox: a window manager that can iconify and that closes windows by asking them."""

    def __init__(self, folder, screen=SCREEN):
        self.log = open(pathlib.Path(folder) / "display.log", "w", encoding="utf-8")
        self.processes = []
        try:
            reading, writing = os.pipe()
            # -r: a key that is held does not repeat itself, however slow the frames are. -noreset: the server does not begin anew when the
            # last client leaves, which those that come just then do not survive.
            server = ["Xvfb", "-displayfd", str(writing), "-screen", "0", screen, "-nolisten", "tcp", "-r", "-noreset"]
            self._start(server, pass_fds=[writing])
            os.close(writing)
            with os.fdopen(reading) as numbers:
                if not select.select([numbers], [], [], 30)[0]:
                    raise AssertionError("Xvfb does not start")
                self.name = ":" + numbers.readline().strip()
            if self.name == ":":
                raise AssertionError("Xvfb ended at once; see display.log")
            # Its defaults: what the user has configured is not used.
            nothing = {"XDG_CONFIG_HOME": str(folder), "XDG_CACHE_HOME": str(folder), "XDG_DATA_HOME": str(folder)}
            manager = self._start(["openbox", "--sm-disable"], env=self.environment() | nothing)
            # A window that is mapped while its manager starts may never hear that it is visible, which GLFW 3.3 waits for without end.
            wait_for(self._is_managed, "the window manager", alive=[manager])
        except BaseException:
            self.close()
            raise

    def environment(self):
        return os.environ | {"DISPLAY": self.name}

    def _start(self, command, **options):
        process = subprocess.Popen(command, stdout=self.log, stderr=self.log, preexec_fn=end_with_parent, **options)
        self.processes.append(process)
        return process

    def _is_managed(self):
        display = xlib.Display(self.name)
        try:
            manager = display.intern_atom("_NET_SUPPORTING_WM_CHECK")
            return display.screen().root.get_full_property(manager, X.AnyPropertyType) is not None
        finally:
            display.close()

    def close(self):
        for process in reversed(self.processes):
            stop(process)
        self.log.close()
