// Two pictures over each other, divided by a line that mouse, touch and keys move; zoom to the pixel, pan, read pixel values.

// left, right: pictures; scale 0: fitted; x, y: the pictures' corner in CSS pixels of the port; divide: per cent of its width.
const view = { left: null, right: null, divide: 50, scale: 0, x: 0, y: 0 };
const parts = {};
const scaleSteps = [1, 2, 4, 8, 16];

const pictureSize = () => sample(state.group).size;
const fittedScale = () => parts.port.clientWidth / pictureSize()[0];
const scaleNow = () => view.scale || fittedScale();
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

function buildCompare() {
  const layer = (side) => el("div", { class: `layer ${side}` }, el("img", { alt: "", draggable: "false" }));
  parts.leftSelect = el("select", { id: "compare-left", "aria-label": "Left picture" });
  parts.rightSelect = el("select", { id: "compare-right", "aria-label": "Right picture" });
  parts.left = layer("left"), parts.right = layer("right");
  parts.divider = el("div", {
    class: "divider", id: "divider", role: "slider", tabindex: "0", "aria-label": "Divider between the two pictures",
    "aria-orientation": "horizontal", "aria-valuemin": "0", "aria-valuemax": "100",
  }, el("span", { class: "grip", "aria-hidden": "true" }));
  parts.port = el("div", { class: "port", id: "port" }, parts.left, parts.right, parts.divider);
  parts.readout = el("output", { class: "readout", "aria-live": "off" });
  parts.zooms = el("div", { class: "zooms", role: "group", "aria-label": "Zoom" }, [0, ...scaleSteps].map((scale) =>
    el("button", { type: "button", "data-scale": scale, onclick: () => zoomTo(scale) }, scale === 0 ? "Fit" : `${scale}×`)));
  const swap = el("button", {
    type: "button", class: "swap", title: "Swap the two pictures", "aria-label": "Swap the two pictures",
    onclick: () => showPair(view.right, view.left),
  }, "⇄");
  byId("compare").replaceChildren(
    el("div", { class: "choices" }, parts.leftSelect, swap, parts.rightSelect),
    parts.port, el("div", { class: "under" }, parts.zooms, parts.readout));
  parts.leftSelect.addEventListener("change", () => showPair(parts.pictures.get(parts.leftSelect.value), view.right));
  parts.rightSelect.addEventListener("change", () => showPair(view.left, parts.pictures.get(parts.rightSelect.value)));
  parts.divider.addEventListener("keydown", onDividerKey);
  listenToPointers();
  new ResizeObserver(() => { if (view.left !== null) place(); }).observe(parts.port);
}

// A technique's picture and its reference: of the first technique that differs from it in a pixel, for two equal pictures show nothing.
function firstPair(references, own) {
  const pairs = own.map((row) => [row.own[0], counterpart(row, row.own[0]) ?? references[0]?.picture]).filter(([, other]) => other);
  const all = [...references.map(({ picture }) => picture), ...own.flatMap((row) => row.own)];
  return pairs.find(([a, b]) => a.index !== b.index) ?? pairs[0] ?? [all[0], all.find((other) => other.index !== all[0].index) ?? all[1] ?? all[0]];
}

function renderCompare() {
  const { references, own } = groupPictures();
  if (references.length === 0 && own.length === 0) return;
  parts.pictures = new Map([...references.map(({ picture }) => picture), ...own.flatMap((row) => row.own)].map((picture) => [picture.id, picture]));
  const option = (picture, name) => ({ label: name ? `${name}: ${picture.label}` : picture.label, value: picture.id });
  const entries = own.map((row) => ({ label: row.label, options: row.own.map((picture) => option(picture, row.label)) }));
  if (references.length) entries.unshift({ label: "Reference", options: references.map(({ picture }) => option(picture)) });
  for (const select of [parts.leftSelect, parts.rightSelect]) fillSelect(select, entries, "");
  const [width, height] = pictureSize();
  parts.port.style.setProperty("--aspect", width / height);
  view.scale = 0, view.divide = 50;
  showPair(...firstPair(references, own));
}

function showPair(left, right) {
  view.left = left ?? view.left, view.right = right ?? view.right ?? left;
  for (const [side, picture] of [["left", view.left], ["right", view.right]]) {
    const image = parts[side].firstChild;
    image.src = pictureUri(picture);
    const select = parts[`${side}Select`];
    select.value = picture.id;
    const chosen = select.selectedOptions[0];
    image.alt = parts[side].dataset.label = chosen?.label ?? "";
  }
  place();
}

// Puts view into style: both pictures move as one, the right one is cut at the divider.
function place() {
  const [width, height] = pictureSize(), scale = scaleNow();
  const free = (port, picture) => (picture <= port ? [(port - picture) / 2, (port - picture) / 2] : [port - picture, 0]);
  view.x = clamp(view.x, ...free(parts.port.clientWidth, width * scale));
  view.y = clamp(view.y, ...free(parts.port.clientHeight, height * scale));
  for (const side of ["left", "right"]) {
    const style = parts[side].firstChild.style;
    style.width = `${width * scale}px`, style.height = `${height * scale}px`;
    style.transform = `translate(${view.x}px, ${view.y}px)`;
    style.imageRendering = scale * devicePixelRatio > 1.5 ? "pixelated" : "auto";
  }
  parts.right.style.clipPath = `inset(0 0 0 ${view.divide}%)`;
  parts.left.style.clipPath = `inset(0 ${100 - view.divide}% 0 0)`;
  parts.divider.style.left = `${view.divide}%`;
  parts.divider.setAttribute("aria-valuenow", String(Math.round(view.divide)));
  parts.divider.setAttribute("aria-valuetext", `${Math.round(view.divide)} % left picture`);
  parts.port.classList.toggle("zoomed", view.scale > 0);
  for (const button of parts.zooms.children) {
    button.setAttribute("aria-pressed", String(Number(button.dataset.scale) === view.scale));
  }
}

// Zooms about a point of the port (its centre by default): what lies there stays there.
function zoomTo(scale, atX = parts.port.clientWidth / 2, atY = parts.port.clientHeight / 2) {
  const before = scaleNow(), fitted = fittedScale();
  view.scale = scale <= 0 || Math.abs(scale - fitted) < 1e-6 ? 0 : clamp(scale, Math.min(fitted, 1), 32);
  const ratio = scaleNow() / before;
  view.x = atX - (atX - view.x) * ratio, view.y = atY - (atY - view.y) * ratio;
  place();
}

function divideAt(percent) {
  view.divide = clamp(percent, 0, 100);
  place();
}

function onDividerKey(event) {
  const step = event.shiftKey ? 10 : 1;
  const moves = {
    ArrowLeft: view.divide - step, ArrowDown: view.divide - step, ArrowRight: view.divide + step, ArrowUp: view.divide + step,
    PageDown: view.divide - 10, PageUp: view.divide + 10, Home: 0, End: 100,
  };
  if (!(event.key in moves)) return;
  event.preventDefault();
  divideAt(moves[event.key]);
}

// One pointer moves the divider, or the picture where it is zoomed in and the divider is not what was taken; two pinch.
function listenToPointers() {
  const { port, divider } = parts, pointers = new Map();
  let dragsDivider = false, pinch = null;
  const spot = (event) => {
    const box = port.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { distance: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  };

  port.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pointers.set(event.pointerId, spot(event));
    port.setPointerCapture(event.pointerId);
    if (pointers.size === 2) pinch = { ...spread(), scale: scaleNow() };
    dragsDivider = pointers.size === 1 && (divider.contains(event.target) || view.scale === 0);
    if (dragsDivider) divideAt((100 * spot(event).x) / port.clientWidth);
    divider.focus({ preventScroll: true });
    if (event.pointerType === "mouse") event.preventDefault();
  });
  port.addEventListener("pointermove", (event) => {
    const now = spot(event), before = pointers.get(event.pointerId);
    readPixels(now);
    if (!before) return;
    pointers.set(event.pointerId, now);
    if (pointers.size === 2 && pinch) {
      const next = spread();
      zoomTo(pinch.scale * next.distance / pinch.distance, next.x, next.y);
    } else if (dragsDivider) divideAt((100 * now.x) / port.clientWidth);
    else { view.x += now.x - before.x, view.y += now.y - before.y; place(); }
  });
  const release = (event) => { pointers.delete(event.pointerId); if (pointers.size < 2) pinch = null; };
  for (const name of ["pointerup", "pointercancel"]) port.addEventListener(name, release);
  port.addEventListener("pointerleave", () => { parts.readout.textContent = ""; });
  // Only with Ctrl (which a trackpad's pinch reports, too): the wheel alone belongs to the page.
  port.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    const at = spot(event);
    zoomTo(scaleNow() * 2 ** (-event.deltaY / 200), at.x, at.y);
  }, { passive: false });
}

const probe = el("canvas", { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });

function readPixels({ x, y }) {
  const [width, height] = pictureSize(), scale = scaleNow();
  const px = Math.floor((x - view.x) / scale), py = Math.floor((y - view.y) / scale);
  if (px < 0 || py < 0 || px >= width || py >= height) { parts.readout.textContent = ""; return; }
  const colour = (side) => {
    const image = parts[side].firstChild;
    if (!image.complete || !image.naturalWidth) return dash;
    probe.drawImage(image, px, py, 1, 1, 0, 0, 1, 1);
    return [...probe.getImageData(0, 0, 1, 1).data.slice(0, 3)].join(" ");
  };
  parts.readout.textContent = `x ${px}  y ${py}   left ${colour("left")}   right ${colour("right")}`;
}
