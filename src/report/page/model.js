// The results as the page uses them: groups of rows, what is selected, and what follows from it.

const data = JSON.parse(byId("gnomon-data").textContent);

const kinds = {
  pixel: { label: "pixels", words: "what each pixel should show: the mean over points within it" },
  area: { label: "area light", words: "the light in its real size, seen from the middle of each pixel" },
  hard: { label: "hard shadows", words: "one ray to the middle of the light, from the middle of each pixel" },
};
const stageNames = ["surface", "build", "resolve", "shade"];
const stageHelp = {
  surface: "camera culling and surface buffer",
  build: "maps, blur, structures",
  resolve: "filling the mask",
  shade: "shading from the mask",
};

// A picture's name as people say it; keys that are not known yet show as they are.
const pictureNames = {
  "shaded": "shaded", "mask": "mask", "error.pixel": "error, pixel",
  "error.area": "error, area", "error.hard": "error, hard",
  "reference_shaded": "shaded reference", "reference.pixel": "reference mask, pixel",
  "reference.area": "reference mask, area", "reference.hard": "reference mask, hard",
};

function flattenPictures(images, prefix = "") {
  const pictures = [];
  for (const [key, value] of Object.entries(images ?? {})) {
    const name = prefix + key;
    const label = pictureNames[name] ?? name.replaceAll(".", " ");
    if (Number.isInteger(value)) pictures.push({ key: name, label, index: value });
    else if (value && typeof value === "object") pictures.push(...flattenPictures(value, name + "."));
  }
  return pictures;
}

// In the order of pictureNames: keys of a line are sorted by their names only.
function picturesOf(raw) {
  const order = Object.keys(pictureNames);
  const rank = (picture) => (order.includes(picture.key) ? order.indexOf(picture.key) : order.length);
  return flattenPictures(raw.images).sort((a, b) => rank(a) - rank(b));
}

const isReference = (picture) => picture.key.startsWith("reference");

function makeRow(raw, index) {
  const available = raw.status === "ok";
  // Files of equal content are embedded once, and are still different pictures: an id says whose and what, an index where the bytes are.
  // References are the same for all rows that share their bytes.
  const pictures = picturesOf(raw).map((picture) =>
    ({ ...picture, id: isReference(picture) ? `${picture.key} ${picture.index}` : `${picture.key} of row ${index}` }));
  return {
    raw, index, available,
    label: raw.label,
    ...Object.fromEntries(Object.keys(kinds).map((kind) => [kind, (available && raw.visibility?.[kind]) || null])),
    gpu: (available && raw.gpu_ms) || {},
    passes: (available && raw.passes) || [],
    memory: available ? raw.memory_bytes : null,
    psnr: available ? raw.image?.psnr : null,
    pictures,
    own: pictures.filter((picture) => !isReference(picture)),
    references: pictures.filter(isReference),
  };
}

const groups = data.groups.map((group) => ({ title: group.title, rows: group.rows.map(makeRow) }));

const percent = (share) => (isNumber(share) ? 100 * share : null);
const percentText = (value) => withUnit(formatPercent(value / 100), "%");

const metrics = {
  mae: { label: "mean absolute error", axis: "mean absolute error", value: (v) => v?.mae, text: formatError },
  rmse: { label: "RMS error", axis: "RMS error", value: (v) => v?.rmse, text: formatError },
  false_shadow: {
    label: "false shadow, area", axis: "false shadow, % of receivers",
    value: (v) => percent(v?.false_shadow?.area), text: percentText,
  },
  false_light: {
    label: "false light, area", axis: "false light, % of receivers",
    value: (v) => percent(v?.false_light?.area), text: percentText,
  },
};

const state = {
  group: groups[0],
  kind: data.against ?? "pixel",
  metric: "mae",
  sort: { key: `mae_${data.against ?? "pixel"}`, ascending: true },
  hiddenStages: new Set(),
  bars: "ms",  // or "share": of the shown passes of each row
  expanded: new Set(),
};

const kindsOf = (group) => Object.keys(kinds).filter((kind) => group.rows.some((row) => row[kind]));

// A label in two: the technique, and the settings in which it differs from other rows of the same technique.
function labelParts(row) {
  const { technique } = row.raw;
  return row.label.startsWith(technique) ? [technique, row.label.slice(technique.length).trim()] : [row.label, ""];
}

// "single/pcf size=2048": charts have no room for the owner of a setting.
const chartLabel = (row) => {
  const [technique, settings] = labelParts(row);
  return `${technique} ${settings.replace(/(^| )[\w.]*\.(\w+=)/g, "$1$2")}`.trim();
};

// What the rows of a group have in common; the first row speaks for all, by how groups are made.
const sample = (group) => group.rows[0].raw;

// Rows that no other row beats in both cost and error, from cheap to dear.
function paretoFront(points) {
  const front = [];
  for (const point of [...points].sort((a, b) => a.x - b.x || a.y - b.y)) {
    if (front.length === 0 || point.y < front[front.length - 1].y) front.push(point);
  }
  return front;
}

// Points of the cost chart: rows with a positive time (the axis is logarithmic) and the chosen error.
function costPoints() {
  return state.group.rows
    .map((row) => ({ row, x: row.gpu.total, y: metrics[state.metric].value(row[state.kind]) }))
    .filter((point) => isNumber(point.x) && point.x > 0 && isNumber(point.y));
}
