// Cost against error: one point per row, the Pareto front as a line through those that nothing beats.

const overlaps = (a, b) => a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;

// Corners at which a label of w x h may start, from the point; the best place first.
function labelPlaces(w, h) {
  const gap = 9;
  return [
    [gap, -h / 2], [-gap - w, -h / 2], [gap - 4, -h - 4], [4 - gap - w, -h - 4], [gap - 4, 4], [4 - gap - w, 4],
    [-w / 2, -h - gap + 2], [-w / 2, gap - 2],
  ];
}

// Writes each point's name at the first place where it covers no point, no other name and no edge. Points on the front come
// first; another point whose name fits nowhere keeps it for the tooltip.
const pointLabels = {
  id: "pointLabels",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea: area } = chart, colours = chartColours();
    const points = chart.data.datasets[0].data.map((point, i) => ({ point, at: chart.getDatasetMeta(0).data[i] }));
    const taken = points.map(({ at }) => ({ x: at.x - 5, y: at.y - 5, w: 10, h: 10 }));
    const size = chart.width < 520 ? 11 : 12;
    const fits = (box) => box.x >= area.left && box.x + box.w <= area.right + 4 && box.y >= area.top - 6 &&
      box.y + box.h <= area.bottom + 2 && !taken.some((other) => overlaps(box, other));
    ctx.save();
    Object.assign(ctx, { textBaseline: "middle", lineWidth: 3, strokeStyle: colours.panel, lineJoin: "round" });
    for (const { point, at } of [...points].sort((a, b) => b.point.onFront - a.point.onFront)) {
      ctx.font = cssFont(size, point.onFront ? 600 : 400);
      const text = shortened(ctx, chartLabel(point.row), Math.min(260, area.width * 0.7));
      const w = ctx.measureText(text).width + 2, h = size + 3;
      const box = labelPlaces(w, h).map(([dx, dy]) => ({ x: at.x + dx, y: at.y + dy, w, h })).find(fits);
      if (!box) continue;
      taken.push(box);
      ctx.fillStyle = point.onFront ? colours.ink : colours.muted;
      ctx.strokeText(text, box.x + 1, box.y + h / 2);
      ctx.fillText(text, box.x + 1, box.y + h / 2);
    }
    ctx.restore();
  },
};

// 1, 2, 5 of each decade.
function logTick(value) {
  const mantissa = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  return [1, 2, 5].some((m) => Math.abs(m - mantissa) < 1e-6) ? plainTick(value) : "";
}

// Filled circles on the front, hollow diamonds off it: told apart without colour.
function costDatasets(points, front, colours) {
  const onFront = (yes, no) => (c) => (c.raw?.onFront ? yes : no);
  return [
    {
      data: points, pointHoverRadius: 7, pointHitRadius: 12, borderWidth: 1.75,
      pointRadius: onFront(5.5, 4.5), pointStyle: onFront("circle", "rectRot"),
      pointBackgroundColor: onFront(colours.accent, colours.panel),
      pointBorderColor: onFront(colours.accent, colours.muted),
    },
    {
      data: front, showLine: true, pointRadius: 0, pointHitRadius: 0,
      borderColor: colours.accent, borderWidth: 1.5, borderDash: [5, 4], order: 1,
    },
  ];
}

function costOptions(points, colours, canvas) {
  const metric = metrics[state.metric], xs = points.map((point) => point.x);
  const range = { min: Math.min(...xs) / 1.6, max: Math.max(...xs) * 1.9 };
  const logTicks = { callback: logTick, maxRotation: 0, autoSkip: false };
  return {
    animation: false, maintainAspectRatio: false, layout: { padding: { top: 10, right: 6 } },
    onClick: openOnClick((index) => points[index].row),
    onHover: (event, hits) => { canvas.style.cursor = hits.length ? "pointer" : ""; },
    scales: {
      x: chartAxis(colours, "GPU time, build + resolve, ms (logarithmic)", { type: "logarithmic", ...range, ticks: logTicks }),
      y: chartAxis(colours, metric.axis, { beginAtZero: true, grace: "8%", ticks: { maxTicksLimit: 7, callback: plainTick } }),
    },
    plugins: {
      legend: { display: false },
      tooltip: chartTooltip(colours, {
        title: (items) => items[0]?.raw.row.label,
        label: ({ raw }) => [`${metric.label}: ${metric.text(raw.y)}`, `GPU time: ${withUnit(formatMs(raw.x), "ms")}`,
          raw.onFront ? "on the Pareto front" : "another is cheaper and more exact"],
      }, { filter: (item) => item.datasetIndex === 0 }),
    },
  };
}

function costNote(shown) {
  const without = state.group.rows.length - shown;
  return [
    "Filled points on the dashed line are the Pareto front: nothing else is both cheaper and more exact.",
    `Against ${kinds[state.kind].label}.`,
    without > 0 ? `${plural(without, "row")} without time or error ${without === 1 ? "is" : "are"} not shown.` : "",
  ].join(" ");
}

let costChart = null;

function renderCostChart() {
  costChart?.destroy();
  costChart = null;
  const colours = chartColours(), points = costPoints(), front = paretoFront(points), canvas = byId("cost-chart");
  byId("cost-panel").hidden = points.length === 0;
  if (points.length === 0) return;
  for (const point of points) point.onFront = front.includes(point) ? 1 : 0;
  points.sort((a, b) => a.onFront - b.onFront);  // the front is drawn over the others
  costChart = new Chart(canvas, {
    type: "scatter",
    plugins: [pointLabels],
    data: { datasets: costDatasets(points, front, colours) },
    options: costOptions(points, colours, canvas),
  });
  const names = front.map((point) => point.row.label).join(", ");
  canvas.setAttribute("aria-label", `${metrics[state.metric].label} over GPU time, ${plural(points.length, "point")}; ` +
    `on the Pareto front: ${names}. The table holds the same figures.`);
  byId("cost-note").textContent = costNote(points.length);
}
