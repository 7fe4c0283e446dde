"""Drives a report.html in headless Chromium: sorting, rows, slider, charts, phone, dark mode, escaping, no network.

usage: test_report.py [--chromium PATH] [--chromedriver PATH] [--screenshots DIR] REPORT.html
Works on the sample of tests/web/make_sample_report.cpp and on any real report.
"""
import argparse
import base64
import json
import pathlib
import sys
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--hide-scrollbars", "--disable-dev-shm-usage"]
LIGHT, DARK = "light", "dark"


class Failure(Exception):
    """A check that does not hold; its text says what was expected and what was seen."""


def require(holds, text):
    if not holds:
        raise Failure(text)


class Page:
    def __init__(self, arguments):
        options = Options()
        if arguments.chromium:
            options.binary_location = arguments.chromium
        for flag in FLAGS:
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        service = Service(arguments.chromedriver) if arguments.chromedriver else Service()
        self.driver = webdriver.Chrome(service=service, options=options)
        self.url = pathlib.Path(arguments.report).resolve().as_uri()
        # Each log is handed out once: what was read is kept.
        self.console, self.network = [], []

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def one(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def collect_logs(self):
        self.console += self.driver.get_log("browser")
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] in ("Network.requestWillBeSent", "Network.webSocketCreated"):
                parameters = message["params"]
                self.network.append(parameters.get("request", parameters)["url"])

    def open(self, width=1280, height=900, scheme=LIGHT, mobile=False):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 2 if mobile else 1, "mobile": mobile})
        self.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": mobile})
        self.set_scheme(scheme)
        self.driver.get(self.url)
        WebDriverWait(self.driver, 60).until(lambda _: self.js("return !document.getElementById('main').hidden"))
        WebDriverWait(self.driver, 60).until(lambda _: self.js("return [...document.images].every(i => i.complete)"))
        self.collect_logs()

    def set_scheme(self, scheme):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                    {"features": [{"name": "prefers-color-scheme", "value": scheme}]})

    def screenshot(self, path):
        size = self.js("return [innerWidth, document.documentElement.scrollHeight]")
        # Chromium's surfaces end at 16384 pixels.
        clip = {"x": 0, "y": 0, "width": size[0], "height": min(size[1], 8000), "scale": 1}
        # Twice: a canvas that was never on the screen is painted only from the second time on.
        for _ in range(2):
            shot = self.driver.execute_cdp_cmd("Page.captureScreenshot", {"captureBeyondViewport": True, "clip": clip})
        path.write_bytes(base64.b64decode(shot["data"]))


def column(page, key):
    """Values of a column as shown from top to bottom; None where nothing was measured."""
    values = page.js("return [...document.querySelectorAll(`#figures tr.row td[data-key=\"${arguments[0]}\"]`)]"
                     ".map(cell => cell.dataset.value)", key)
    return [float(value) if value else None for value in values]


def row_order(page):
    return page.js("return [...document.querySelectorAll('#figures tr.row')].map(row => row.dataset.row)")


def check_groups_select(page):
    options = page.js("return [...document.querySelectorAll('#group option')].map(o => o.textContent)")
    if len(options) < 2:
        return "one configuration, no selector"
    before = page.one("#facts").text + page.one("#figures").text
    Select(page.one("#group")).select_by_index(1)
    require(page.one("#facts").text + page.one("#figures").text != before, "choosing another scene changes nothing")
    Select(page.one("#group")).select_by_index(0)
    require(page.one("#facts").text + page.one("#figures").text == before, "choosing the first scene again gives another page")
    return f"{len(options)} configurations"


def check_sorting(page):
    sorted_columns, changes = [], 0
    keys = page.js("return [...document.querySelectorAll('#figures thead th[data-key]')].map(h => h.dataset.key)")
    for key in keys:
        head = f'#figures thead th[data-key="{key}"]'
        for state in ("ascending", "descending"):
            before = row_order(page)
            button = page.one(f"{head} button")
            # By click and by keyboard in turn.
            if state == "ascending" and page.one(head).get_attribute("aria-sort") != "ascending":
                page.js("arguments[0].click()", button)
            elif state == "descending":
                page.js("arguments[0].focus()", button)
                button.send_keys(Keys.ENTER)
            require(page.one(head).get_attribute("aria-sort") == state, f"{key}: aria-sort is not {state}")
            others = page.js("return document.querySelectorAll('#figures th[aria-sort]:not([aria-sort=none])').length")
            require(others == 1, f"{key}: {others} columns say that they are sorted")
            values = column(page, key)
            known = [value for value in values if value is not None]
            require(values[:len(known)] == known, f"{key}: rows without a value do not stand last: {values}")
            require(known == sorted(known, reverse=state == "descending"), f"{key} {state}: wrong order {known}")
            changes += row_order(page) != before
        if len(known) > 1:
            sorted_columns.append(key)
    require(len(page.all("#figures tr.row")) < 2 or changes > 0, "sorting never changes the order of rows")
    # Names are text, and each is another: one direction is the other reversed.
    names = []
    for _ in range(2):
        page.js("document.getElementById('sort-technique').click()")
        names.append(page.js("return [...document.querySelectorAll('#figures tr.row .label')].map(l => l.innerText)"))
    require(names[0] == names[1][::-1], f"technique: {names[0]} is not the reverse of {names[1]}")
    # Punctuation and case are the browser's to order: only names of letters and digits are compared here.
    plain = [name for name in names[0] if name.isalnum()]
    require(plain in (sorted(plain), sorted(plain)[::-1]), f"technique: wrong order {plain}")
    return f"{len(keys)} columns, {len(sorted_columns)} with figures, both directions, {changes} changes of order"


def check_rows_expand(page):
    commands = page.js("return JSON.parse(document.getElementById('gnomon-data').textContent)"
                       ".groups[0].rows.map(row => row.command)")
    for index in range(min(len(commands), 12)):
        button = page.one(f"#open-{index}")
        page.js("arguments[0].click()", button)
        shown = page.js("return document.querySelector(arguments[0])?.textContent", f"#details-{index} .command code")
        require(shown == commands[index], f"row {index} shows the command {shown!r}, not {commands[index]!r}")
        require(page.one(f"#open-{index}").get_attribute("aria-expanded") == "true", "aria-expanded does not follow")
        text = page.js("return document.getElementById(arguments[0]).textContent", f"details-{index}")
        require("undefined" not in text and "NaN" not in text and "[object" not in text, f"row {index}: {text}")
    page.js("document.querySelector('.copy').click()")
    WebDriverWait(page.driver, 10).until(lambda _: page.js("return document.querySelector('.copy').textContent") != "Copy")
    require(page.js("return document.querySelector('.copy').textContent") == "Copied", "the copy button does not copy")
    page.js("document.getElementById('open-0').click()")
    require(not page.all("#details-0"), "a row does not close again")
    return f"{min(len(commands), 12)} rows, command and copy button"


def check_texts(page):
    text = page.js("return document.body.innerText")
    for wrong in ("undefined", "NaN", "[object Object]", "Infinity"):
        require(wrong not in text, f"the page shows '{wrong}'")
    reasons = page.js("return JSON.parse(document.getElementById('gnomon-data').textContent).groups[0].rows"
                      ".filter(row => row.status === 'unavailable').map(row => row.reason)")
    shown = page.js("return [...document.querySelectorAll('#figures .unavailable .reason')].map(cell => cell.textContent)")
    require(sorted(shown) == sorted(reason or "no reason given" for reason in reasons), f"reasons shown: {shown}, given: {reasons}")
    return f"{len(text)} characters, {len(reasons)} unavailable with reason"


def clip(page):
    return page.js("return getComputedStyle(document.querySelector('.layer.right')).clipPath")


def check_slider(page):
    if page.js("return document.getElementById('compare-section').hidden"):
        return "no pictures in these results"
    page.js("document.getElementById('port').scrollIntoView({block: 'center'})")
    divider = page.one("#divider")
    require(divider.get_attribute("role") == "slider", "the divider is no slider")
    start = clip(page)
    width = page.js("return document.getElementById('port').clientWidth")
    ActionChains(page.driver).drag_and_drop_by_offset(divider, -int(width / 4), 0).perform()
    dragged = clip(page)
    require(dragged != start, f"dragging leaves the clip at {start}")
    value = float(divider.get_attribute("aria-valuenow"))
    require(abs(value - 25) < 2, f"dragged by a quarter of the width from the middle, the divider stands at {value} %")
    divider.send_keys(Keys.ARROW_RIGHT)
    require(clip(page) != dragged, "the right arrow does not move the clip")
    require(abs(float(divider.get_attribute("aria-valuenow")) - value - 1) < 1.01, "the right arrow is not one per cent")
    divider.send_keys(Keys.END)
    require(clip(page) == "inset(0px 0px 0px 100%)", f"End gives {clip(page)}")
    divider.send_keys(Keys.HOME)
    require(divider.get_attribute("aria-valuenow") == "0", "Home does not go to 0")
    for _ in range(5):
        divider.send_keys(Keys.PAGE_UP)
    require(divider.get_attribute("aria-valuenow") == "50", "PageUp is not ten per cent")
    return f"{start} -> {dragged} -> keys"


def check_touch(page):
    if page.js("return document.getElementById('compare-section').hidden"):
        return "no pictures in these results"
    page.js("document.getElementById('port').scrollIntoView({block: 'center'})")
    box = page.js("const b = document.getElementById('port').getBoundingClientRect(); return [b.left, b.top, b.width, b.height]")
    before = clip(page)
    spot = lambda share: [{"x": box[0] + box[2] * share, "y": box[1] + box[3] * 0.5}]
    touch = lambda kind, points: page.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    touch("touchStart", spot(0.5))
    for share in (0.55, 0.6, 0.7, 0.8):
        touch("touchMove", spot(share))
    touch("touchEnd", [])
    value = float(page.one("#divider").get_attribute("aria-valuenow"))
    require(clip(page) != before and abs(value - 80) < 3, f"a finger moved to 80 % leaves the divider at {value} %")
    return f"finger to {value:.0f} %"


def check_pair(page):
    """Every picture has an entry of its own, whatever its bytes, and the page opens with two that differ where there are two."""
    if page.js("return document.getElementById('compare-section').hidden"):
        return "no pictures in these results"
    options = page.js("return [...document.querySelectorAll('#compare-left option')].map(o => [o.value, o.textContent])")
    require(len(set(value for value, _ in options)) == len(options), f"two entries stand for one picture: {options}")
    require(len(set(label for _, label in options)) == len(options), f"two entries have one label: {options}")
    rows = page.js("return JSON.parse(document.getElementById('gnomon-data').textContent).groups[0].rows.map(row => row.images ?? {})")
    leaves = lambda tree: sum((leaves(child) for child in tree.values()), []) if isinstance(tree, dict) else [tree]
    own = sum(len(leaves({key: value for key, value in row.items() if not key.startswith("reference")})) for row in rows)
    require(sum(": " in label for _, label in options) == own, f"{own} pictures of techniques, entries: {options}")
    chosen = page.js("return ['left', 'right'].map(side => document.getElementById('compare-' + side).value)")
    sources = page.js("return ['left', 'right'].map(side => document.querySelector(`.layer.${side} img`).src)")
    require(chosen[0] != chosen[1], f"the page opens with {chosen[0]} on both sides")
    shaded = [(row["shaded"], row["reference_shaded"]) for row in rows if "shaded" in row and "reference_shaded" in row]
    if any(a != b for a, b in shaded):
        require(sources[0] != sources[1], f"the page opens with two equal pictures: {chosen}")
    return f"{len(options)} entries, opens with {' and '.join(chosen)}"


def check_ticks(page):
    axes = {"cost-chart": "y", "passes-chart": "x"}
    shown = [name for name in axes if page.one(f"#{name}").is_displayed()]
    for name in shown:
        texts = page.js("const text = Chart.getChart(arguments[0]).config.options.scales[arguments[1]].ticks.callback;"
                        "return [0, 5e-6, 2.5000000000000003e-5, 0.0010000000000000002, 0.30000000000000004, 20].map(value => text(value))",
                        name, axes[name])
        require(texts == ["0", "5e-6", "2.5e-5", "0.001", "0.3", "20"], f"ticks of {name} read {texts}")
    return f"{len(shown)} charts"


def check_menus_and_zoom(page):
    if page.js("return document.getElementById('compare-section').hidden"):
        return "no pictures in these results"
    select = Select(page.one("#compare-left"))
    pictures = len(select.options)
    source = lambda: page.js("return document.querySelector('.layer.left img').src.length + ' ' + document.querySelector('.layer.left img').src.slice(-200)")
    if pictures > 1:
        before = source()
        other = next(i for i in range(pictures) if not select.options[i].is_selected())
        select.select_by_index(other)
        require(source() != before, "choosing another picture does not show it")
    style = lambda: page.js("const s = getComputedStyle(document.querySelector('.layer.left img')); return [s.width, s.imageRendering]")
    page.js("document.querySelector('[data-scale=\"8\"]').click()")
    width = page.js("return JSON.parse(document.getElementById('gnomon-data').textContent).groups[0].rows[0].size[0]")
    require(style() == [f"{8 * width}px", "pixelated"], f"8x of {width} pixels gives {style()}")
    transform = page.js("return document.querySelector('.layer.left img').style.transform")
    ActionChains(page.driver).move_to_element_with_offset(page.one("#port"), 120, 60).click_and_hold().move_by_offset(40, 30).release().perform()
    moved = page.js("return document.querySelector('.layer.left img').style.transform")
    require(moved != transform, "a zoomed picture does not pan")
    require(page.js("return document.querySelector('.layer.right img').style.transform") == moved, "the two pictures pan apart")
    page.js("document.querySelector('[data-scale=\"0\"]').click()")
    page.js("document.querySelector('.thumbnail').click()")
    return f"{pictures} pictures to choose from, zoom to {8 * width} pixels, pan"


CANVAS_COLOURS = """
const canvas = document.getElementById(arguments[0]);
const pixels = new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer);
const seen = new Map();
for (const pixel of pixels) seen.set(pixel, (seen.get(pixel) ?? 0) + 1);
const blank = Math.max(...seen.values());
return [seen.size, pixels.length - blank];
"""


def check_charts(page):
    drawn = {}
    rows = page.js("return JSON.parse(document.getElementById('gnomon-data').textContent).groups[0].rows")
    timed = any(row.get("passes") for row in rows)
    compared = any((row.get("gpu_ms") or {}).get("total") and (row.get("visibility") or {}).get("hard", {}).get("mae") is not None for row in rows)
    for name, expected in (("cost-chart", compared), ("passes-chart", timed)):
        if not page.one(f"#{name}").is_displayed():
            require(not expected, f"{name} is hidden although the results have its figures")
            continue
        colours, pixels = page.js(CANVAS_COLOURS, name)
        require(colours > 8 and pixels > 500, f"{name} is blank: {colours} colours, {pixels} pixels drawn")
        drawn[name] = pixels
    shot = lambda name: page.js("return document.getElementById(arguments[0]).toDataURL()", name)
    if "cost-chart" in drawn:
        before = shot("cost-chart")
        Select(page.one("#metric")).select_by_value("rmse")
        require(shot("cost-chart") != before, "the choice of error does not change the chart")
        Select(page.one("#metric")).select_by_value("mae")
    before, stage = shot("passes-chart"), page.all("#stages button")
    if stage:
        page.js("arguments[0].click()", stage[-1])
        require(shot("passes-chart") != before, "hiding a stage does not change the chart")
        page.js("arguments[0].click()", page.all("#stages button")[-1])
    return ", ".join(f"{name} {pixels} pixels" for name, pixels in drawn.items()) or "nothing to draw"


def check_no_script_from_data(page):
    require(page.js("return window.hostile") is None, "a string of the results was run as script")
    images = page.js("return [...document.images].filter(i => i.getAttribute('src') !== null && !i.src.startsWith('data:image/png;base64,'))"
                     ".map(i => i.src)")
    require(not images, f"pictures that are not embedded: {images}")
    broken = page.js("return [...document.images].filter(i => i.complete && i.src && !i.naturalWidth).length")
    require(broken == 0, f"{broken} pictures cannot be decoded")
    scripts = page.js("return document.querySelectorAll('script').length")
    require(scripts == 3, f"{scripts} script elements instead of data, Chart.js and the page's own")
    return "strings stay text, all pictures embedded and decoded"


def check_pictures_once(page):
    pictures = page.js("return JSON.parse(document.getElementById('gnomon-data').textContent).pictures")
    require(len(pictures) == len(set(pictures)), "a picture is embedded more than once")
    return f"{len(pictures)} pictures, each once"


def background(page):
    return page.js("return getComputedStyle(document.body).backgroundColor")


def luminance(colour):
    return sum(float(part) for part in colour[colour.index("(") + 1:-1].split(",")[:3]) / 3


def check_dark(page):
    name = next((name for name in ("cost-chart", "passes-chart") if page.one(f"#{name}").is_displayed()), None)
    picture = lambda: page.js("return document.getElementById(arguments[0])?.toDataURL()", name)
    light, chart = background(page), picture()
    page.set_scheme(DARK)
    time.sleep(0.3)
    dark = background(page)
    require(luminance(light) > 200 and luminance(dark) < 60, f"background {light} in light, {dark} in dark mode")
    require(not name or picture() != chart, "the chart keeps its light colours")
    text = page.js("return getComputedStyle(document.body).color")
    require(luminance(text) > 180, f"text is {text} in dark mode")
    page.set_scheme(LIGHT)
    return f"{light} -> {dark}"


def check_phone(page):
    """At 360 pixels nothing stands out of the page; tables scroll in their own container."""
    page.js("document.querySelectorAll('.name button')[0].click()")
    width = page.js("return [document.documentElement.scrollWidth, innerWidth]")
    require(width == [360, 360], f"the page is {width[0]} wide on {width[1]} pixels")
    outside = page.js("""
      const clipped = (e) => e.closest('.scroller, .inner-scroller, .port, .offscreen, noscript');
      return [...document.body.querySelectorAll('*')].filter((e) => !clipped(e) || e.matches('.scroller, .port'))
        .filter((e) => { const b = e.getBoundingClientRect(); return b.width > 0 && (b.right > innerWidth + 0.5 || b.left < -0.5); })
        .map((e) => e.tagName + '.' + e.className + '#' + e.id);""")
    require(not outside, f"these stand out of the page: {outside[:5]}")
    details = page.js("const b = document.querySelector('.details').getBoundingClientRect(); return [b.left, b.right]")
    require(details[0] >= 0 and details[1] <= 360, f"an opened row lies at {details}")
    for name in ("cost-chart", "passes-chart"):
        if page.one(f"#{name}").is_displayed():
            colours, pixels = page.js(CANVAS_COLOURS, name)
            require(colours > 8 and pixels > 500, f"{name} is blank on a phone")
    return "360 wide, no overflow"


def check_console(page):
    page.collect_logs()
    wrong = [entry["message"] for entry in page.console if entry["level"] in ("SEVERE", "WARNING")]
    require(not wrong, f"console: {wrong[:5]}")
    return "no errors, no warnings"


def check_network(page):
    page.collect_logs()
    # chrome:// and about: are the browser's own start page.
    outside = [url for url in page.network if not url.startswith(("data:", "chrome", "about:")) and url != page.url]
    require(page.url in page.network, "the network log does not even show the page: this check would see nothing")
    require(not outside, f"requests left the file: {outside[:5]}")
    entries = page.js("return performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:'))")
    require(not entries, f"resources loaded: {entries[:5]}")
    policy = page.js("return document.querySelector('meta[http-equiv=\"Content-Security-Policy\"]').content")
    require(policy.startswith("default-src 'none'"), f"content security policy: {policy}")
    return f"{len(page.network)} requests, all data: or the page itself"


DESKTOP = [("scene selector", check_groups_select), ("texts", check_texts), ("sorting", check_sorting),
           ("rows open", check_rows_expand), ("charts", check_charts), ("ticks", check_ticks),
           ("pair of pictures", check_pair), ("slider", check_slider),
           ("menus and zoom", check_menus_and_zoom), ("data stays data", check_no_script_from_data),
           ("pictures", check_pictures_once), ("dark mode", check_dark)]
PHONE = [("phone", check_phone), ("touch", check_touch)]
LAST = [("console", check_console), ("network", check_network)]


def run(page, checks):
    failures = 0
    for name, check in checks:
        try:
            print(f"  ok      {name}: {check(page)}", flush=True)
        except Failure as failure:
            print(f"  FAILED  {name}: {failure}", flush=True)
            failures += 1
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report")
    parser.add_argument("--chromium")
    parser.add_argument("--chromedriver")
    parser.add_argument("--screenshots", type=pathlib.Path, help="folder for pictures of the page, 1280 and 360 wide, light and dark")
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.report).is_file():
        sys.exit(f"{arguments.report}: no such file")
    page = Page(arguments)
    try:
        page.open()
        failures = run(page, DESKTOP)
        page.open(width=360, height=740, mobile=True)
        failures += run(page, PHONE + LAST)
        if arguments.screenshots:
            arguments.screenshots.mkdir(parents=True, exist_ok=True)
            for width, scheme in ((1280, LIGHT), (1280, DARK), (360, LIGHT), (360, DARK)):
                page.open(width=width, scheme=scheme, mobile=width == 360)
                page.screenshot(arguments.screenshots / f"report-{width}-{scheme}.png")
    finally:
        page.driver.quit()
    count = len(DESKTOP + PHONE + LAST)
    print(f"{arguments.report}: {count - failures} of {count} checks hold")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
