// Two charts: cost against error with its Pareto front, and the time of each pass. Chart.js draws; labels are our own.

const narrow = (chart) => chart.width < 520;

function chartColours() {
  const names = ["ink", "muted", "line", "panel", "accent", "surface", "build", "resolve", "shade"];
  return Object.fromEntries(names.map((name) => [name, cssColour(`--${name}`)]));
}

const overlaps = (a, b) => a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;

// Writes each point's name at the first place of six where it covers no point, no other name and no edge. Points on the front
// come first; another point whose name fits nowhere keeps it for the tooltip.
const pointLabels = {
  id: "pointLabels",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea } = chart, colours = chartColours();
    const points = chart.data.datasets[0].data.map((point, i) => ({ point, at: chart.getDatasetMeta(0).data[i] }));
    const taken = points.map(({ at }) => ({ x: at.x - 5, y: at.y - 5, w: 10, h: 10 }));
    const size = narrow(chart) ? 11 : 12;
    ctx.save();
    ctx.textBaseline = "middle";
    for (const { point, at } of [...points].sort((a, b) => b.point.onFront - a.point.onFront)) {
      ctx.font = cssFont(size, point.onFront ? 600 : 400);
      const text = shortened(ctx, point.row.label, Math.min(220, chartArea.width * 0.6));
      const w = ctx.measureText(text).width + 2, h = size + 3, gap = 9;
      const places = [[gap, -h / 2], [-gap - w, -h / 2], [gap - 4, -h - 4], [-w - gap + 4, -h - 4], [gap - 4, 4], [-w - gap + 4, 4], [-w / 2, -h - gap + 2], [-w / 2, gap - 2]];
      const box = places.map(([dx, dy]) => ({ x: at.x + dx, y: at.y + dy, w, h })).find((candidate) =>
        candidate.x >= chartArea.left && candidate.x + w <= chartArea.right + 4 && candidate.y >= chartArea.top - 6 &&
        candidate.y + h <= chartArea.bottom + 2 && !taken.some((other) => overlaps(candidate, other)));
      if (!box) continue;
      taken.push(box);
      ctx.fillStyle = point.onFront ? colours.ink : colours.muted;
      ctx.lineWidth = 3, ctx.strokeStyle = colours.panel, ctx.lineJoin = "round";
      ctx.strokeText(text, box.x + 1, box.y + h / 2);
      ctx.fillText(text, box.x + 1, box.y + h / 2);
    }
    ctx.restore();
  },
};

function shortened(ctx, text, width) {
  if (ctx.measureText(text).width <= width) return text;
  let length = text.length;
  while (length > 1 && ctx.measureText(text.slice(0, length) + "…").width > width) --length;
  return text.slice(0, length) + "…";
}

// Names above the bars, totals at their right: long names cost no width, which a phone has not.
const barLabels = {
  id: "barLabels",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea } = chart, colours = chartColours(), rows = chart.options.rows;
    ctx.save();
    ctx.textBaseline = "alphabetic";
    rows.forEach(({ row, total }, i) => {
      const y = chart.scales.y.getPixelForValue(i) - 12;
      ctx.font = cssFont(12, 600), ctx.fillStyle = colours.muted, ctx.textAlign = "right";
      const text = withUnit(formatMs(total), "ms");
      ctx.fillText(text, chartArea.right, y);
      const room = chartArea.width - ctx.measureText(text).width - 12;
      ctx.font = cssFont(12), ctx.fillStyle = colours.ink, ctx.textAlign = "left";
      ctx.fillText(shortened(ctx, row.label, room), chartArea.left, y);
    });
    ctx.restore();
  },
};

function axis(colours, title, more = {}) {
  return {
    title: { display: true, text: title, color: colours.muted, font: { size: 12 } },
    grid: { color: (c) => (c.tick?.label === "" ? "transparent" : colours.line), borderColor: colours.line, tickColor: "transparent" },
    ...more,
    ticks: { color: colours.muted, font: { size: 11 }, ...more.ticks },
  };
}

function tooltip(colours, callbacks) {
  return {
    backgroundColor: colours.ink, titleColor: colours.panel, bodyColor: colours.panel, displayColors: false, padding: 10,
    cornerRadius: 6, callbacks,
  };
}

// 1, 2, 5 of each decade; more would run together.
function logTick(value) {
  const mantissa = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  return [1, 2, 5].some((m) => Math.abs(m - mantissa) < 1e-6) ? String(Number(value.toPrecision(3))) : "";
}

let costChart = null, passesChart = null;

function renderCostChart() {
  costChart?.destroy();
  const colours = chartColours(), metric = metrics[state.metric];
  const points = costPoints(), front = paretoFront(points);
  for (const point of points) point.onFront = front.includes(point) ? 1 : 0;
  const xs = points.map((point) => point.x);
  const range = xs.length ? { min: Math.min(...xs) / 1.6, max: Math.max(...xs) * 1.9 } : { min: 0.1, max: 10 };
  const canvas = byId("cost-chart");
  costChart = new Chart(canvas, {
    type: "scatter",
    plugins: [pointLabels],
    data: {
      datasets: [
        {
          data: points, pointRadius: (c) => (c.raw?.onFront ? 5.5 : 4.5), pointHoverRadius: 7, pointHitRadius: 12, borderWidth: 1.75,
          pointStyle: (c) => (c.raw?.onFront ? "circle" : "rectRot"),
          pointBackgroundColor: (c) => (c.raw?.onFront ? colours.accent : colours.panel),
          pointBorderColor: (c) => (c.raw?.onFront ? colours.accent : colours.muted),
        },
        { data: front, showLine: true, pointRadius: 0, pointHitRadius: 0, borderColor: colours.accent, borderWidth: 1.5, borderDash: [5, 4], order: 1 },
      ],
    },
    options: {
      animation: false, maintainAspectRatio: false, layout: { padding: { top: 10, right: 6 } },
      onClick: (event, hits) => { if (hits.length) showRow(points[hits[0].index].row); },
      onHover: (event, hits) => { canvas.style.cursor = hits.length ? "pointer" : ""; },
      scales: {
        x: axis(colours, "GPU time, build + resolve, ms (logarithmic)", { type: "logarithmic", ...range, ticks: { callback: logTick, maxRotation: 0, autoSkip: false } }),
        y: axis(colours, metric.axis, { beginAtZero: true, grace: "8%", ticks: { maxTicksLimit: 7 } }),
      },
      plugins: {
        legend: { display: false },
        tooltip: { ...tooltip(colours, {
          title: (items) => items[0]?.raw.row.label,
          label: ({ raw }) => [`${metric.label}: ${metric.text(raw.y)}`, `GPU time: ${withUnit(formatMs(raw.x), "ms")}`, raw.onFront ? "on the Pareto front" : "beaten in both by another"],
        }), filter: (item) => item.datasetIndex === 0 },
      },
    },
  });
  const without = state.group.rows.length - points.length;
  canvas.setAttribute("aria-label", `${metric.label} over GPU time of ${points.length} techniques; on the Pareto front: ${front.map((p) => p.row.label).join(", ")}. The table holds the same figures.`);
  byId("cost-note").textContent = [
    "Filled points on the dashed line are the Pareto front: nothing else is both cheaper and more exact.",
    `Against ${kinds[state.kind].label}.`,
    without > 0 ? `${plural(without, "row")} without time or error ${without === 1 ? "is" : "are"} not shown.` : "",
  ].join(" ");
}

const stageOf = (pass) => (stageNames.includes(pass.stage) ? pass.stage : "surface");
const passTime = (pass) => (isNumber(pass.median_ms) ? pass.median_ms : 0);

// One data set for the n-th pass of each stage, so that passes of one stage share its colour and stand side by side.
function passDatasets(rows, colours) {
  const datasets = [], length = (pass, total) => (!pass ? 0 : state.bars === "ms" ? passTime(pass) : (100 * passTime(pass)) / (total || 1));
  for (const stage of stageNames.filter((name) => !state.hiddenStages.has(name))) {
    const passes = rows.map(({ row }) => row.passes.filter((pass) => stageOf(pass) === stage));
    const count = Math.max(0, ...passes.map((list) => list.length));
    for (let n = 0; n < count; ++n) {
      datasets.push({
        label: stage, data: passes.map((list, i) => length(list[n], rows[i].total)), passes: passes.map((list) => list[n]),
        backgroundColor: colours[stage], borderColor: colours.panel, borderSkipped: false,
        borderWidth: (c) => ({ right: (c.parsed?.x ?? 0) > 0.012 * c.chart.scales.x.max ? 1 : 0 }), barThickness: 13, stack: "passes",
      });
    }
  }
  return datasets;
}

function renderStages() {
  const present = stageNames.filter((stage) => state.group.rows.some((row) => row.passes.some((pass) => stageOf(pass) === stage)));
  const toggle = (stage) => () => {
    if (!state.hiddenStages.delete(stage)) state.hiddenStages.add(stage);
    renderPassesChart();
    byId(`stage-${stage}`).focus();
  };
  byId("stages").replaceChildren(...present.map((stage) => el("button", {
    type: "button", id: `stage-${stage}`, title: stageHelp[stage], "aria-pressed": String(!state.hiddenStages.has(stage)), onclick: toggle(stage),
  }, el("i", { class: `dot ${stage}` }), stage)));
}

function renderPassesChart() {
  passesChart?.destroy();
  renderStages();
  const colours = chartColours();
  const shown = (pass) => !state.hiddenStages.has(stageOf(pass));
  const rows = state.group.rows.filter((row) => row.passes.length > 0)
    .map((row) => ({ row, total: row.passes.filter(shown).reduce((sum, pass) => sum + passTime(pass), 0) }))
    .sort((a, b) => a.total - b.total || a.row.index - b.row.index);
  const canvas = byId("passes-chart");
  canvas.parentElement.style.height = `${rows.length * 40 + 58}px`;
  // Many bars need the height that a page has, not the half width beside the other chart.
  canvas.closest(".charts").classList.toggle("stacked", rows.length > 14);
  passesChart = new Chart(canvas, {
    type: "bar",
    plugins: [barLabels],
    data: { labels: rows.map(({ row }) => row.label), datasets: passDatasets(rows, colours) },
    options: {
      rows, indexAxis: "y", animation: false, maintainAspectRatio: false, layout: { padding: { top: 8 } },
      onClick: (event, hits) => { if (hits.length) showRow(rows[hits[0].index].row); },
      scales: {
        x: axis(colours, state.bars === "ms" ? "median, ms" : "share of the row's shown passes, %", { stacked: true, beginAtZero: true, max: state.bars === "ms" ? undefined : 100, ticks: { maxTicksLimit: 6, maxRotation: 0 } }),
        y: { stacked: true, display: false },
      },
      plugins: {
        legend: { display: false },
        tooltip: tooltip(colours, {
          title: (items) => items[0]?.label,
          label: ({ dataset: { passes, label }, dataIndex }) => [`${passes[dataIndex]?.name ?? ""} (${label})`, withUnit(formatMs(passes[dataIndex]?.median_ms), "ms")],
        }),
      },
    },
  });
  canvas.setAttribute("aria-label", `Time of passes: ${rows.map(({ row, total }) => `${row.label} ${formatMs(total)} ms`).join(", ")}.`);
  const clocks = [...new Set(state.group.rows.map(({ raw }) => raw.timing && [raw.timing.mode && `mode ${raw.timing.mode}`, raw.timing.clock].filter(Boolean).join(", ")).filter(Boolean))];
  byId("passes-note").textContent = ["Build and resolve are the technique's own; surface and shade are the same work for all.",
    clocks.length ? `Timed in ${clocks.join("; ")}.` : ""].join(" ");
}

function renderCharts() {
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  renderCostChart();
  renderPassesChart();
}
