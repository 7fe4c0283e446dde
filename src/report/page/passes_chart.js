// Time of the passes: one stacked bar per row, coloured by stage; stages can be hidden.

const stageOf = (pass) => (stageNames.includes(pass.stage) ? pass.stage : "surface");
const passTime = (pass) => (isNumber(pass?.median_ms) ? pass.median_ms : 0);

// Names above the bars, totals at their right: long names cost no width, which a phone has not.
const barLabels = {
  id: "barLabels",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea: area } = chart, colours = chartColours();
    ctx.save();
    Object.assign(ctx, { textBaseline: "alphabetic", lineWidth: 4, strokeStyle: colours.panel, lineJoin: "round" });
    const write = (text, x, y) => { ctx.strokeText(text, x, y); ctx.fillText(text, x, y); };
    chart.options.rows.forEach(({ row, total }, i) => {
      const y = chart.scales.y.getPixelForValue(i) - 12;
      ctx.font = cssFont(12, 600), ctx.fillStyle = colours.muted, ctx.textAlign = "right";
      const text = withUnit(formatMs(total), "ms");
      write(text, area.right, y);
      const room = area.width - ctx.measureText(text).width - 12;
      ctx.font = cssFont(12), ctx.fillStyle = colours.ink, ctx.textAlign = "left";
      write(shortened(ctx, chartLabel(row), room), area.left, y);
    });
    ctx.restore();
  },
};

// One data set for the n-th pass of each stage, so that passes of one stage share its colour and stand side by side.
function passDatasets(rows, colours) {
  const datasets = [];
  const length = (pass, total) => (state.bars === "ms" ? passTime(pass) : (100 * passTime(pass)) / (total || 1));
  // A gap between passes, unless it would swallow a short one.
  const gap = (c) => ({ right: (c.parsed?.x ?? 0) > 0.012 * c.chart.scales.x.max ? 1 : 0 });
  for (const stage of stageNames.filter((name) => !state.hiddenStages.has(name))) {
    const passes = rows.map(({ row }) => row.passes.filter((pass) => stageOf(pass) === stage));
    const count = Math.max(0, ...passes.map((list) => list.length));
    for (let n = 0; n < count; ++n) {
      datasets.push({
        label: stage, passes: passes.map((list) => list[n]), data: passes.map((list, i) => length(list[n], rows[i].total)),
        backgroundColor: colours[stage], borderColor: colours.panel, borderSkipped: false, borderWidth: gap,
        barThickness: 13, stack: "passes",
      });
    }
  }
  return datasets;
}

function passesOptions(rows, colours) {
  const inMs = state.bars === "ms";
  const ticks = { maxTicksLimit: 6, maxRotation: 0, callback: plainTick };
  const lengthAxis = { isBare: true, stacked: true, beginAtZero: true, max: inMs ? undefined : 100, ticks };
  return {
    rows, indexAxis: "y", animation: false, maintainAspectRatio: false, layout: { padding: { top: 8 } },
    onClick: openOnClick((index) => rows[index].row),
    scales: {
      x: chartAxis(colours, inMs ? "median, ms" : "share of the row's shown passes, %", lengthAxis),
      y: { stacked: true, display: false },
    },
    plugins: {
      legend: { display: false },
      tooltip: chartTooltip(colours, {
        title: (items) => items[0]?.label,
        label: ({ dataset: { passes, label }, dataIndex }) =>
          [`${passes[dataIndex]?.name ?? ""} (${label})`, withUnit(formatMs(passes[dataIndex]?.median_ms), "ms")],
      }),
    },
  };
}

function renderStages() {
  const isPresent = (stage) => state.group.rows.some((row) => row.passes.some((pass) => stageOf(pass) === stage));
  const toggle = (stage) => () => {
    if (!state.hiddenStages.delete(stage)) state.hiddenStages.add(stage);
    renderPassesChart();
    byId(`stage-${stage}`).focus();
  };
  byId("stages").replaceChildren(...stageNames.filter(isPresent).map((stage) => el("button", {
    type: "button", id: `stage-${stage}`, title: stageHelp[stage],
    "aria-pressed": String(!state.hiddenStages.has(stage)), onclick: toggle(stage),
  }, el("i", { class: `dot ${stage}` }), stage)));
}

function passesNote() {
  const text = ({ timing }) => timing && [timing.mode && `mode ${timing.mode}`, timing.clock].filter(Boolean).join(", ");
  const clocks = [...new Set(state.group.rows.map(({ raw }) => text(raw)).filter(Boolean))];
  return ["Build and resolve are the technique's own; surface and shade are the same work for all.",
    clocks.length ? `Timed in ${clocks.join("; ")}.` : ""].join(" ");
}

let passesChart = null;

function renderPassesChart() {
  passesChart?.destroy();
  passesChart = null;
  const colours = chartColours(), canvas = byId("passes-chart");
  const isShown = (pass) => !state.hiddenStages.has(stageOf(pass));
  const rows = state.group.rows.filter((row) => row.passes.length > 0)
    .map((row) => ({ row, total: row.passes.filter(isShown).reduce((sum, pass) => sum + passTime(pass), 0) }))
    .sort((a, b) => a.total - b.total || a.row.index - b.row.index);
  byId("passes-panel").hidden = rows.length === 0;
  if (rows.length === 0) return;
  renderStages();
  canvas.parentElement.style.height = `${rows.length * 40 + 58}px`;
  // Many bars need the height that a page has, not the half width beside the other chart.
  canvas.closest(".charts").classList.toggle("stacked", rows.length > 14);
  passesChart = new Chart(canvas, {
    type: "bar",
    plugins: [barLabels],
    data: { labels: rows.map(({ row }) => row.label), datasets: passDatasets(rows, colours) },
    options: passesOptions(rows, colours),
  });
  const figures = rows.map(({ row, total }) => `${row.label} ${formatMs(total)} ms`).join(", ");
  canvas.setAttribute("aria-label", `Time of the passes: ${figures}.`);
  byId("passes-note").textContent = passesNote();
}

function renderCharts() {
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  // Both must be laid out before either is drawn, or the first takes the width that the second leaves it.
  for (const name of ["cost-panel", "passes-panel"]) byId(name).hidden = false;
  renderCostChart();
  renderPassesChart();
}
