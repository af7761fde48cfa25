"""Walks the window through AT-SPI, as a screen reader does, and flies a plan by actions alone.

Everything that is shown must have a role (what Qt knows nothing of is a "filler") and whatever takes
the keyboard a name, in the window with each of its panels and in every dialog; the map and the
charts must have a table twin. Then a trade-off is chosen, the plan is flown, what happens is
announced, and the plan is exported.

Use: accessibility_walk.py BERGWATCH SCENARIO WORK_DIR
"""

import os
import subprocess
import sys
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, GLib  # noqa: E402
import pyatspi  # noqa: E402

PATIENCE_MS = 60000  # for one answer
PATIENCE_S = 300  # for what takes a moment; a busy machine takes longer
LONGEST = 40  # children of one object that are looked at: the rows of a table are alike
NO_ROLE = ("filler", "unknown", "invalid")
failures = []
announced = []


def check(holds, what):
    print(("ok: " if holds else "FAILED: ") + what, flush=True)
    if not holds:
        failures.append(what)


def children(node):
    for index in range(min(node.childCount, LONGEST)):
        child = node.getChildAtIndex(index)
        if child is not None:
            yield child


def descendants(node):
    """What went away while it was asked is left out."""
    yield node
    try:
        below = list(children(node))
    except (GLib.Error, RuntimeError, NotImplementedError):
        return
    for child in below:
        yield from descendants(child)


def has(node, *states):
    present = node.getState()
    return all(present.contains(state) for state in states)


def is_seen(node):
    """Shown, and on the screen: Qt keeps tab bars for later beyond its edges."""
    if not has(node, pyatspi.STATE_SHOWING):
        return False
    try:
        extent = node.queryComponent().getExtents(pyatspi.DESKTOP_COORDS)
    except NotImplementedError:
        return True
    return min(extent.width, extent.height, extent.x + extent.width, extent.y + extent.height) > 0


def plain(text):
    return text.replace("&", "").replace("\u2026", "...").strip()


def role_of(node):
    """AT-SPI 2.56 calls a push button a button."""
    name = node.getRoleName()
    return "push button" if name == "button" else name


def find(root, role, name, holds=is_seen):
    for node in descendants(root):
        try:
            if role_of(node) == role and name in plain(node.name) and holds(node):
                return node
        except (GLib.Error, RuntimeError):
            continue
    return None


def wait_for(what, look):
    """Whatever comes of `look` that is not nothing; events are taken meanwhile."""
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        while GLib.MainContext.default().iteration(False):
            pass
        try:
            found = look()
        except (GLib.Error, RuntimeError):
            found = None
        if found:
            return found
        time.sleep(0.1)
    check(False, what + " came within %d s" % PATIENCE_S)
    raise SystemExit(1)


def act(node, name=None):
    """The first thing that can be done with it, or the one of that name. What opens a modal dialog
    answers when that is closed: nobody waits for it."""
    actions = node.queryAction()
    names = [actions.getName(i) for i in range(actions.nActions)]
    Atspi.set_timeout(1000, 1000)
    try:
        actions.doAction(names.index(name) if name else 0)
    except (GLib.Error, RuntimeError):
        print("no answer yet of " + node.name, file=sys.stderr)
    finally:
        Atspi.set_timeout(PATIENCE_MS, PATIENCE_MS)


def path_of(node):
    parts = []
    while node is not None and node.getRoleName() != "desktop frame" and len(parts) < 6:
        parts.append("%s '%s'" % (node.getRoleName(), node.name))
        node = node.parent
    return " < ".join(parts)


def walk(root, what, least=4):
    """All that is shown has a role, and all that takes the keyboard a name."""
    seen = fillers = nameless = 0
    for node in descendants(root):
        try:
            if not is_seen(node):
                continue
            seen += 1
            if node.getRoleName() in NO_ROLE:
                fillers += 1
                print("    no role: " + path_of(node))
            is_cell = node.getRoleName() == "table cell"  # one may be empty
            if has(node, pyatspi.STATE_FOCUSABLE) and not is_cell and not node.name.strip():
                nameless += 1
                print("    no name: " + path_of(node))
        except (GLib.Error, RuntimeError):
            continue
    check(seen >= least, "%s: %d objects" % (what, seen))
    check(fillers == 0, "%s: %d without a role" % (what, fillers))
    check(nameless == 0, "%s: %d that take the keyboard have no name" % (what, nameless))


class Window:
    def __init__(self, app):
        self.app = app

    def frame(self):
        return next(n for n in children(self.app) if n.name.endswith("- Bergwatch"))

    def commands(self):
        """Of all menus, also of those that are not open."""

        def below(node):
            for child in children(node):
                if child.childCount > 0:
                    yield from below(child)
                elif child.getRoleName() != "separator":
                    yield child

        yield from below(find(self.frame(), "menu bar", ""))

    def command(self, name):
        return next((n for n in self.commands() if plain(n.name) == name), None)

    def do(self, name):
        act(wait_for("the command " + name, lambda: self.command(name)))

    def others(self):
        """Windows beside the first one: dialogs and what else is shown apart."""
        return [n for n in children(self.app) if is_seen(n) and not n.name.endswith("- Bergwatch")]

    def open(self, name):
        self.do(name)
        return wait_for("what %s opens" % name, lambda: next(iter(self.others()), None))

    def close(self, dialog):
        for name in ("Cancel", "Close", "OK"):
            button = find(dialog, "push button", name)
            if button is not None:
                act(button)
                break
        wait_for("the end of '%s'" % dialog.name, lambda: not self.others())


def show_panel(window, name):
    """Before those that it shares a place with."""
    entries = children(window.command("Map layers").parent)
    entry = next(entry for entry in entries if plain(entry.name) == name)
    act(entry)
    if not has(entry, pyatspi.STATE_CHECKED):  # it was there, behind others
        act(entry)
    return wait_for("the panel " + name, lambda: find(window.app, "frame", name))


def walk_panels(window):
    for entry in list(children(window.command("Map layers").parent)):
        walk(show_panel(window, plain(entry.name)), "panel '%s'" % plain(entry.name))


def walk_dialogs(window):
    for command in (
        "Open...",
        "Save as...",
        "Export plan...",
        "Flight brief...",
        "Generate icebergs...",
        "Move the scenario...",
        "Wind...",
        "Keyboard shortcuts",
        "About Bergwatch",
    ):
        dialog = window.open(command)
        walk(dialog, "what %s opens" % command)
        window.close(dialog)


def read_tables(window):
    """What is drawn can be read in rows: the map in the table of icebergs, a chart by an action."""
    table = find(show_panel(window, "Icebergs"), "table", "Icebergs")
    check(table.queryTable().nRows == 12, "the icebergs of the map are rows of a table")
    for panel, name in (
        ("First chart", "Uncertainty now and accumulated"),
        ("Pareto curve", "Distance against uncertainty reward"),
    ):
        act(find(show_panel(window, panel), "chart", name), "Show values as a table")
        values = wait_for("the values", lambda: next(iter(window.others()), None))
        walk(values, "values of '%s'" % name)
        rows = find(values, "table", name).queryTable()
        check(rows.nRows > 1 and rows.nColumns > 1, "%s: %d rows" % (name, rows.nRows))
        check(all(rows.getColumnHeader(i).name for i in range(rows.nColumns)), "its columns have names")
        window.close(values)


def choose(window):
    """The next policy of the list and another tau, after which the plan is another one."""
    policy = wait_for("the policies", lambda: find(window.app, "combo box", "Policy: "))
    before = policy.name
    act(policy, "Increase")
    wait_for("another policy", lambda: policy.name != before)
    check(policy.name.startswith("Policy: "), "the policy says what it is of: " + policy.name)
    act(policy, "Decrease")
    wait_for("the policy before", lambda: policy.name == before)

    def distance():
        return find(window.app, "label", "Whole order: ").name

    known = wait_for("the length of the plan", distance)
    tau = wait_for("the trade-off", lambda: find(window.app, "spin button", "Trade-off"))
    tau.queryValue().currentValue = 0.5
    wait_for("another plan", lambda: distance() != known)
    check(True, "another tau makes another plan: %s, %s" % (known, distance()))


def fly(window):
    for _ in range(2):
        window.do("Faster")
    # The buttons of the aircraft panel that fly something are disabled.
    flies = lambda n: is_seen(n) and "aircraft" not in n.name and "mission" not in n.name
    act(wait_for("the button that flies", lambda: find(window.app, "push button", "Fly", flies)), "Press")
    wait_for("the end of the flight", lambda: find(window.app, "label", "State: Run complete"))
    events = find(window.app, "table", "Events of the mission", lambda n: True).queryTable()
    told = [events.getAccessibleAt(row, 1).name for row in range(events.nRows)]
    check(any("reached" in what for what in told), "icebergs reached are among the events")
    wait_for("the end, announced", lambda: any("Run complete" in what for what in announced))
    check(any("Flying" in what for what in announced), "take-off is announced")
    check(any("reached" in what for what in announced), "icebergs reached are announced")


def export(window, output):
    dialog = window.open("Export plan...")
    act(wait_for("the format", lambda: find(dialog, "list item", "GeoJSON")), "Toggle")
    path = os.path.join(output, "exported.geojson")
    file = find(dialog, "text", "File")
    wait_for("its ending", lambda: file.queryText().getText(0, -1).endswith(".geojson"))
    file.queryEditableText().setTextContents(path)
    ready = lambda: find(dialog, "push button", "Export", lambda n: has(n, pyatspi.STATE_ENABLED))
    act(wait_for("the button that exports", ready))
    wait_for("the file", lambda: os.path.exists(path))
    with open(path, encoding="utf-8") as written:
        check("FeatureCollection" in written.read(), "the plan is exported")
    wait_for("the message about it", lambda: any("Exported" in what for what in announced))
    messages = find(window.app, "list", "Messages", lambda n: True)
    check(any("Exported" in item.name for item in children(messages)), "messages are kept")


def run(window, output):
    wait_for("the map", lambda: find(window.app, "canvas", "Map"))
    walk(window.frame(), "the window at first", 100)
    walk_panels(window)
    walk_dialogs(window)
    choose(window)
    fly(window)
    walk(window.frame(), "the window after the flight", 100)
    read_tables(window)
    export(window, output)
    window.do("Start page")
    is_waiting = lambda n: not n.name and has(n, pyatspi.STATE_FOCUSABLE) and is_seen(n)
    wait_for("the examples", lambda: not find(window.frame(), "push button", "", is_waiting))
    walk(window.frame(), "the window with its start page", 20)
    walk(window.open("Manual"), "the manual", 20)


def listen(event):
    try:
        if event.source.getRoleName() == "notification":
            announced.append(event.source.name)
    except (GLib.Error, RuntimeError):  # it is gone
        pass


def main():
    program, scenario, output = sys.argv[1:]
    Atspi.set_timeout(PATIENCE_MS, PATIENCE_MS)
    pyatspi.Registry.registerEventListener(listen, "object:state-changed:showing")
    process = subprocess.Popen([program, "--config", os.path.join(output, "settings.ini"), scenario])
    desktop = pyatspi.Registry.getDesktop(0)
    try:
        app = wait_for(
            "the program",
            lambda: next((n for n in children(desktop) if n.name == "bergwatch" and n.childCount > 0), None),
        )
        run(Window(app), output)
    finally:
        process.kill()
        process.wait()
        for what in failures:
            print("failed: " + what, file=sys.stderr)
    return 1 if failures else 0


sys.exit(main())
