"""What a user does to windows: keys, mouse, clipboard, and what the window manager does for them. Real events, through XTest."""
import pathlib
import sys

from Xlib import X, XK, Xatom
from Xlib import display as xdisplay
from Xlib.ext import xtest
from Xlib.protocol import event

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "picture"))
import png  # noqa: E402  (of the picture tests)

from display import wait_for

# Names of keys that are not those of their character.
KEYSYMS = {" ": "space", ".": "period", ",": "comma", "-": "minus", "_": "underscore", "/": "slash", "=": "equal", ":": "colon",
           "'": "apostrophe", "%": "percent"}
WHEEL_UP, WHEEL_DOWN = 4, 5
ICONIC_STATE = 3


class Desktop:
    """A connection to the display, beside the program's own."""

    def __init__(self, name):
        self.connection = xdisplay.Display(name)
        self.root = self.connection.screen().root
        wait_for(self._managed, "the window manager")

    def atom(self, name):
        return self.connection.intern_atom(name)

    def _managed(self):
        return self.root.get_full_property(self.atom("_NET_SUPPORTING_WM_CHECK"), Xatom.WINDOW)

    def window_of(self, pid):
        """The window of a process, or None."""
        listed = self.root.get_full_property(self.atom("_NET_CLIENT_LIST"), Xatom.WINDOW)
        for number in listed.value if listed else []:
            window = self.connection.create_resource_object("window", number)
            owner = window.get_full_property(self.atom("_NET_WM_PID"), Xatom.CARDINAL)
            if owner and owner.value[0] == pid:
                return window
        return None

    def title(self, window):
        return window.get_full_property(self.atom("_NET_WM_NAME"), self.atom("UTF8_STRING")).value.decode()

    # The window manager's part.

    def _ask_manager(self, window, name, data):
        message = event.ClientMessage(window=window, client_type=self.atom(name), data=(32, data + [0] * (5 - len(data))))
        self.root.send_event(message, event_mask=X.SubstructureRedirectMask | X.SubstructureNotifyMask)
        self.connection.sync()

    def activate(self, window):
        """Brings it to the front, with the keyboard; a minimised one comes back."""
        user = 2
        self._ask_manager(window, "_NET_ACTIVE_WINDOW", [user])

    def minimise(self, window):
        self._ask_manager(window, "WM_CHANGE_STATE", [ICONIC_STATE])

    def close(self, window):
        self._ask_manager(window, "_NET_CLOSE_WINDOW", [])

    def resize(self, window, width, height):
        window.configure(width=width, height=height)
        self.connection.sync()

    def has_focus(self, window):
        return self.connection.get_input_focus().focus == window

    # Keys and mouse.

    def key(self, name, down):
        """`name`: a character, or X11's name of the key ("Return", "Shift_L")."""
        symbol = XK.string_to_keysym(KEYSYMS.get(name, name))
        code = self.connection.keysym_to_keycode(symbol)
        if not code:
            raise AssertionError(f"no key '{name}' on this keyboard")
        xtest.fake_input(self.connection, X.KeyPress if down else X.KeyRelease, code)
        self.connection.sync()

    def needs_shift(self, character):
        symbol = XK.string_to_keysym(KEYSYMS.get(character, character))
        return self.connection.keycode_to_keysym(self.connection.keysym_to_keycode(symbol), 0) != symbol

    def move(self, x, y):
        """The pointer, in pixels of the screen."""
        xtest.fake_input(self.connection, X.MotionNotify, detail=False, x=round(x), y=round(y))
        self.connection.sync()

    def move_by(self, x, y):
        xtest.fake_input(self.connection, X.MotionNotify, detail=True, x=x, y=y)
        self.connection.sync()

    def button(self, number, down):
        xtest.fake_input(self.connection, X.ButtonPress if down else X.ButtonRelease, number)
        self.connection.sync()

    # How large things are.

    def set_dpi(self, dpi):
        """Of programs that are started from now on: 96 is usual. None: it is not said."""
        name = self.atom("RESOURCE_MANAGER")
        if dpi is None:
            self.root.delete_property(name)
        else:
            self.root.change_property(name, Xatom.STRING, 8, f"Xft.dpi:\t{dpi}\n".encode())
        self.connection.sync()

    # What can be seen and what was copied.

    def origin(self, window):
        """Where the window's own pixel 0, 0 is on the screen."""
        place = self.root.translate_coords(window, 0, 0)
        return place.x, place.y

    def picture(self, drawable=None):
        """(width, height, RGB bytes) of a window, or of the whole screen."""
        drawable = drawable or self.root
        size = drawable.get_geometry()
        data = drawable.get_image(0, 0, size.width, size.height, X.ZPixmap, 0xFFFFFFFF).data  # BGRX
        rgb = bytearray(3 * size.width * size.height)
        for channel in range(3):
            rgb[channel::3] = data[2 - channel::4]
        return size.width, size.height, bytes(rgb)

    def save_picture(self, path, drawable=None):
        png.write(path, *self.picture(drawable))

    def clipboard(self):
        """Its text, or None where nothing was copied."""
        selection, target = self.atom("CLIPBOARD"), self.atom("UTF8_STRING")
        if self.connection.get_selection_owner(selection) == X.NONE:
            return None
        window = self.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        window.convert_selection(selection, target, self.atom("GNOMON_TEST"), X.CurrentTime)
        self.connection.sync()
        answer = wait_for(lambda: self.next_event(X.SelectionNotify), "the owner of the clipboard")
        if answer.property == X.NONE:
            return None
        text = window.get_full_property(answer.property, X.AnyPropertyType).value
        window.destroy()
        return text.decode() if isinstance(text, bytes) else text

    def next_event(self, kind):
        """One that has arrived, else None; those of other kinds are dropped."""
        while self.connection.pending_events():
            arrived = self.connection.next_event()
            if arrived.type == kind:
                return arrived
        return None

    def disconnect(self):
        self.connection.close()
