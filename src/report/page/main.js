// Puts the parts together and redraws what a choice changes.

function renderGroup() {
  const present = kindsOf(state.group);
  if (!present.includes(state.kind)) state.kind = present[0] ?? "hard";
  // A run that only measured time has no errors to sort by.
  if (present.length === 0 && state.sort.key === "mae_hard") state.sort = { key: "total", ascending: true };
  state.expanded.clear();
  byId("error-legend").hidden = present.length === 0;
  renderFacts();
  renderKindSwitch((kind) => { state.kind = kind; renderKind(); renderGallery(); });
  renderKind();
  renderGallery();
  renderCompare();
}

function renderKind() {
  renderSummary();
  renderTable();
  renderCharts();
}

byId("main").hidden = false;
fillSelect(byId("metric"), Object.entries(metrics).map(([value, metric]) => ({ label: metric.label, value })), state.metric);
byId("metric").addEventListener("change", (event) => { state.metric = event.target.value; renderSummary(); renderCostChart(); });
fillSelect(byId("bars"), [{ label: "in ms", value: "ms" }, { label: "as shares", value: "share" }], state.bars);
byId("bars").addEventListener("change", (event) => { state.bars = event.target.value; renderPassesChart(); });
renderGroupSelect((group) => { state.group = group; renderGroup(); });
buildCompare();
renderGroup();
renderSuite();

const renderAllCharts = () => { renderCharts(); renderSuiteCharts(); };
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", renderAllCharts);
// Paper is white: charts are drawn again in the light colours for it.
addEventListener("beforeprint", () => { document.documentElement.dataset.theme = "light"; renderAllCharts(); });
addEventListener("afterprint", () => { delete document.documentElement.dataset.theme; renderAllCharts(); });
