// Rows of a benchmark suite: ratios beside what was published and the goals, and plots of runs over a setting.

const benchLines = data.groups.flatMap((group) => group.rows).filter((row) => row.bench);
const suiteRows = benchLines.flatMap((row) => row.bench.rows ?? []).sort((a, b) => (a.index ?? 0) - (b.index ?? 0));  // in the order of their suite

const formatValue = (value, unit) => (unit === "byte" ? withUnit(formatMiB(value), "MiB") : unit === "" ? formatCount(value) : formatMs(value));
const formatRatio = (value) => orDash(value, (v) => v.toFixed(v >= 10 ? 1 : 2));
const formatRowValue = (row, value) => (row.kind === "ratio" ? formatRatio(value) : formatValue(value, row.unit));

function publishedText(row) {
  const [from, to] = row.published ?? [];
  if (!isNumber(from)) return dash;
  return from === to ? formatRowValue(row, from) : `${formatRowValue(row, from)} to ${formatRowValue(row, to)}`;
}

function metText(row) {
  if (row.kind === "masks") return row.met === null ? dash : row.met ? "equal" : "differ";
  return typeof row.met === "boolean" ? (row.met ? "met" : "missed") : dash;
}

function suiteRow(row) {
  const isRatio = row.kind === "ratio";
  const also = row.also && isNumber(row.also.value) ? `${row.also.of} ${formatRatio(row.also.value)}` : "";
  const cells = [
    row.of ?? "masks", formatValue(row.numerator, row.unit), isRatio ? formatValue(row.denominator, row.unit) : dash,
    row.kind === "masks" ? dash : formatRowValue(row, row.value), publishedText(row), isNumber(row.goal) ? `≤ ${formatRowValue(row, row.goal)}` : dash,
  ];
  return el("tr", {},
    el("th", { scope: "row" }, row.name, row.source && el("small", {}, row.source)),
    cells.map((text) => el("td", {}, text)),
    el("td", { class: row.met === false ? "missed" : null }, metText(row)), el("td", {}, also));
}

function renderSuiteTable() {
  const titles = ["Row", "of", "measured", "over", "value", "published", "goal", "", "also"];
  byId("suite-rows").replaceChildren(
    el("caption", { class: "offscreen" }, "Rows of the suite: measured, published, goal"),
    el("thead", {}, el("tr", {}, titles.map((title) => el("th", { scope: "col" }, title)))),
    el("tbody", {}, suiteRows.map(suiteRow)));
  const suites = [...new Set(benchLines.map((line) => line.bench.suite))].join(", ");
  const small = benchLines.some((line) => line.bench.quick || line.bench.scale !== 1);
  const judged = suiteRows.filter((row) => typeof row.met === "boolean");
  byId("suite-note").textContent = [
    `${suites}: runs of one row were drawn in turns, frame by frame; figures are medians.`,
    judged.length ? `${judged.filter((row) => row.met).length} of ${judged.length} goals are met.` : "",
    small ? "Pictures and maps were scaled down for trying the suite: these figures say nothing about its goals." : "",
  ].filter(Boolean).join(" ");
}

const suiteCharts = [];

// Chart.js has no interval plot: published ranges are floating bars, values are points, on one category axis.
function renderRatios() {
  const rows = suiteRows.filter((row) => row.kind === "ratio" && isNumber(row.value)), canvas = byId("ratios-chart"), colours = chartColours();
  byId("ratios-panel").hidden = rows.length === 0;
  if (rows.length === 0) return;
  canvas.parentElement.style.height = `${rows.length * 26 + 64}px`;
  const least = 0.012 * Math.max(...rows.flatMap((row) => [row.value, row.goal ?? 0, row.published?.[1] ?? 0]));
  const range = ({ published }) => published && [published[0] - least / 2, Math.max(published[1], published[0]) + least / 2];
  const isMissed = (c) => rows[c.dataIndex]?.met === false;
  const point = (value, i) => ({ x: value, y: rows[i].name });
  suiteCharts.push(new Chart(canvas, {
    type: "bar",
    data: {
      labels: rows.map((row) => row.name),
      datasets: [
        {
          type: "scatter", label: "measured", data: rows.map((row, i) => point(row.value, i)), pointRadius: 5, borderWidth: 1.75, order: 0,
          pointBackgroundColor: (c) => (isMissed(c) ? colours.panel : colours.accent), pointBorderColor: colours.accent,
        },
        {
          type: "scatter", label: "goal", data: rows.flatMap((row, i) => (isNumber(row.goal) ? [point(row.goal, i)] : [])), order: 1,
          pointStyle: "line", rotation: 90, pointRadius: 9, pointBorderColor: colours.ink, borderWidth: 2,
        },
        { label: "published", data: rows.map(range), backgroundColor: `${colours.resolve}88`, barThickness: 12, order: 2 },
      ],
    },
    options: {
      indexAxis: "y", animation: false, maintainAspectRatio: false,
      scales: {
        x: chartAxis(colours, "ratio of medians", { beginAtZero: true }),
        y: { type: "category", labels: rows.map((row) => row.name), offset: true, grid: { display: false }, ticks: { color: colours.ink, font: { size: 11 }, autoSkip: false } },
      },
      plugins: {
        legend: { display: false },
        tooltip: chartTooltip(colours, {
          title: (items) => items[0]?.raw?.y ?? items[0]?.label,
          label: ({ dataset, raw }) => `${dataset.label}: ${dataset.label === "published" ? raw.map(formatRatio).join(" to ") : formatRatio(raw.x)}`,
        }),
      },
    },
  }));
  canvas.setAttribute("aria-label", `Ratios: ${rows.map((row) => `${row.name} ${formatRatio(row.value)}`).join(", ")}.`);
}

const ofLine = (line, of) => ({
  frame: line.timing?.frame_ms, technique: line.gpu_ms?.total, build: line.gpu_ms?.build, resolve: line.gpu_ms?.resolve, record: line.timing?.record_ms,
})[of];

// Measured lines are solid, published ones dashed in the same colour; each is scaled to its own device, so only shapes compare.
function renderPlot(title, points) {
  const colours = chartColours(), series = [...new Set(points.map((point) => point.series))];
  const shades = [colours.build, colours.resolve, colours.accent, colours.muted];
  const canvas = el("canvas", { role: "img", "aria-label": `${title}: ${points.map((point) => `${point.series} at ${point.x}: ${formatMs(point.y)} ms`).join(", ")}.` });
  byId("suite-plots").append(el("figure", { class: "panel" }, el("header", {}, el("h2", {}, title)), el("div", { class: "canvas cost" }, canvas),
    el("figcaption", {}, "Solid: measured here. Dashed: published, on another device.")));
  const dataset = (name, i, key, more) => ({
    label: key === "y" ? name : `${name}, published`, showLine: true, borderColor: shades[i % shades.length], backgroundColor: shades[i % shades.length], borderWidth: 1.75,
    data: points.filter((point) => point.series === name && isNumber(point[key])).map((point) => ({ x: point.x, y: point[key] })).sort((a, b) => a.x - b.x), ...more,
  });
  suiteCharts.push(new Chart(canvas, {
    type: "scatter",
    data: { datasets: series.flatMap((name, i) => [dataset(name, i, "y"), dataset(name, i, "published", { borderDash: [5, 4], pointRadius: 2 })]) },
    options: {
      animation: false, maintainAspectRatio: false,
      scales: {
        x: chartAxis(colours, points[0].x_label, { type: "logarithmic", ticks: { callback: (value) => (points.some((point) => point.x === value) ? String(value) : ""), autoSkip: false } }),
        y: chartAxis(colours, "median, ms", { beginAtZero: true, grace: "8%" }),
      },
      plugins: {
        legend: { labels: { color: colours.ink, boxWidth: 12, font: { size: 11 } } },
        tooltip: chartTooltip(colours, { label: ({ dataset: { label }, raw }) => `${label}: ${withUnit(formatMs(raw.y), "ms")} at ${raw.x}` }),
      },
    },
  }));
}

function renderSuiteCharts() {
  for (const chart of suiteCharts.splice(0)) chart.destroy();
  byId("suite-plots").replaceChildren();
  if (benchLines.length === 0) return;
  renderRatios();
  const points = benchLines.filter((line) => line.bench.plot).map((line) => ({ ...line.bench.plot, y: ofLine(line, line.bench.plot.of) })).filter((point) => isNumber(point.y));
  for (const title of new Set(points.map((point) => point.title))) renderPlot(title, points.filter((point) => point.title === title));
}

function renderSuite() {
  byId("suite-section").hidden = suiteRows.length === 0 && !benchLines.some((line) => line.bench.plot);
  if (byId("suite-section").hidden) return;
  renderSuiteTable();
  renderSuiteCharts();
}
