// Puts the parts together and redraws what a choice changes.

function renderGroup() {
  const present = kindsOf(state.group);
  if (!present.includes(state.kind)) state.kind = present[0] ?? "hard";
  // Sorted by an error that this group does not have; a run that only measured time has none.
  if (state.sort.key.startsWith("mae_") && !present.includes(state.sort.key.slice("mae_".length))) {
    state.sort = { key: present.length > 0 ? `mae_${state.kind}` : "total", ascending: true };
  }
  state.expanded.clear();
  byId("error-legend").hidden = present.length === 0;
  renderFacts();
  renderKindSwitch((kind) => {
    if (state.sort.key === `mae_${state.kind}`) state.sort.key = `mae_${kind}`;
    state.kind = kind;
    renderKind();
    renderGallery();
  });
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
