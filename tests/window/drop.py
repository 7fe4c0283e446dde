"""A file manager from which files are dragged onto a window: the source's half of the drag-and-drop protocol of X (XDND, version 5)."""
import pathlib

from Xlib import X, Xatom
from Xlib.protocol import event

from display import wait_for

VERSION = 5


class DragSource:
    def __init__(self, desktop):
        self.desktop = desktop
        self.window = desktop.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        self.answers = {}  # name of the message -> its data

    def drop(self, target, paths, x, y):
        """Drags files to a place of the window, in its own pixels, and lets go. True where the window took them."""
        desktop, connection = self.desktop, self.desktop.connection
        aware = target.get_full_property(desktop.atom("XdndAware"), Xatom.ATOM)
        if not aware:
            raise AssertionError("nothing can be dropped on this window: it has no XdndAware")
        version = min(VERSION, aware.value[0])
        self.data = "".join(pathlib.Path(path).resolve().as_uri() + "\r\n" for path in paths).encode()
        uri_list, copy = desktop.atom("text/uri-list"), desktop.atom("XdndActionCopy")
        left, top = desktop.origin(target)
        place = (round(left + x) << 16) | round(top + y)

        desktop.move(left + x, top + y)  # the button is the source's alone: a drag grabs the pointer
        self.window.set_selection_owner(desktop.atom("XdndSelection"), X.CurrentTime)
        self._send(target, "XdndEnter", [version << 24, uri_list])
        self._send(target, "XdndPosition", [0, place, X.CurrentTime, copy])
        status = self._answer("XdndStatus")
        if not status[1] & 1:
            self._send(target, "XdndLeave", [])
            connection.sync()
            return False
        self._send(target, "XdndDrop", [0, X.CurrentTime])
        return bool(self._answer("XdndFinished")[1])  # GLFW 3.3 writes a number of bytes where the protocol has one bit

    def _send(self, target, name, data):
        values = [self.window.id, *data]
        message = event.ClientMessage(window=target, client_type=self.desktop.atom(name), data=(32, values + [0] * (5 - len(values))))
        target.send_event(message)
        self.desktop.connection.sync()

    def _answer(self, name):
        """Data of the target's message of that name. Until it comes, whoever asks gets the files."""
        self.answers.pop(name, None)

        def arrived():
            connection = self.desktop.connection
            while connection.pending_events():
                one = connection.next_event()
                if one.type == X.ClientMessage:
                    self.answers[connection.get_atom_name(one.client_type)] = one.data[1]
                elif one.type == X.SelectionRequest:
                    self._hand_over(one)
            return self.answers.get(name)

        return wait_for(arrived, f"{name} of the window that the files are dragged to")

    def _hand_over(self, request):
        known = request.target == self.desktop.atom("text/uri-list")
        if known:
            request.requestor.change_property(request.property, request.target, 8, self.data)
        request.requestor.send_event(event.SelectionNotify(time=request.time, requestor=request.requestor, selection=request.selection,
                                                           target=request.target, property=request.property if known else X.NONE))
        self.desktop.connection.sync()

    def close(self):
        self.window.destroy()
