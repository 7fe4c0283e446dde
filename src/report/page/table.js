// The table of figures: columns, sorting, rows that open.

// group: heading above several columns; value: what is sorted by; text: what is shown; bar: its share of the column's largest.
function tableColumns() {
  const column = (key, group, label, value, text, more) => ({ key, group, label, value, text, ...more });
  const of = (value) => (row) => value(row[state.kind] ?? {});
  const columns = [
    column("technique", null, "Technique", (row) => row.label, null, { isText: true }),
    column("status", null, "Status", (row) => row.raw.status, null, { isText: true }),
    ...kindsOf(state.group).map((kind) =>
      column(`mae_${kind}`, "Mean abs. error", kind, (row) => row[kind]?.mae, formatError, { title: `against ${kinds[kind].words}` })),
    column("false_shadow", "False shadow", "area %", of((v) => v.false_shadow?.area), formatPercent, { bar: "shadow" }),
    column("false_shadow_severity", "False shadow", "severity", of((v) => v.false_shadow?.severity), formatShare),
    column("false_light", "False light", "area %", of((v) => v.false_light?.area), formatPercent, { bar: "light" }),
    column("false_light_severity", "False light", "severity", of((v) => v.false_light?.severity), formatShare),
    column("rmse", null, "RMSE", of((v) => v.rmse), formatError),
    column("build", "GPU time, ms", "build", (row) => row.gpu.build, formatMs),
    column("resolve", "GPU time, ms", "resolve", (row) => row.gpu.resolve, formatMs),
    column("total", "GPU time, ms", "total", (row) => row.gpu.total, formatMs, { bar: "time" }),
    column("memory", null, "MiB", (row) => row.memory, formatMiB, { title: "GPU memory of the technique" }),
    column("psnr", null, "PSNR", (row) => row.psnr, formatDb, { title: "shaded picture against its reference, dB" }),
  ];
  return columns;
}

// What has no value stands last in both directions: it is neither small nor large.
function sortedRows(column) {
  const direction = state.sort.ascending ? 1 : -1;
  const compare = (a, b) => {
    const x = column.value(a), y = column.value(b);
    if (column.isText) return direction * String(x).localeCompare(String(y), "en", { numeric: true });
    if (!isNumber(x) || !isNumber(y)) return isNumber(y) - isNumber(x);
    return direction * (x - y);
  };
  return [...state.group.rows].sort((a, b) => compare(a, b) || a.index - b.index);
}

function headCell(column, attributes = {}) {
  const sorted = state.sort.key === column.key;
  const sort = () => {
    state.sort = { key: column.key, ascending: sorted ? !state.sort.ascending : true };
    renderTable();
    byId(`sort-${column.key}`).focus();
  };
  return el("th", {
    scope: "col", "data-key": column.key, class: column.isText ? "text" : "number", title: column.title,
    "aria-sort": sorted ? (state.sort.ascending ? "ascending" : "descending") : "none", ...attributes,
  }, el("button", { type: "button", id: `sort-${column.key}`, onclick: sort }, column.label));
}

function tableHead(columns) {
  const upper = [], lower = [];
  for (const column of columns) {
    if (!column.group) upper.push(headCell(column, { rowspan: 2 }));
    else {
      const span = columns.filter((other) => other.group === column.group).length;
      if (columns.find((other) => other.group === column.group) === column) {
        upper.push(el("th", { scope: "colgroup", colspan: span, class: "group" }, el("span", {}, column.group)));
      }
      lower.push(headCell(column));
    }
  }
  return el("thead", {}, el("tr", {}, upper), el("tr", {}, lower));
}

function nameCell(row) {
  const open = state.expanded.has(row), [technique, settings] = labelParts(row);
  const toggle = () => {
    if (!state.expanded.delete(row)) state.expanded.add(row);
    renderTable();
    byId(`open-${row.index}`).focus();
  };
  return el("th", { scope: "row", class: "name" },
    el("button", {
      type: "button", id: `open-${row.index}`, onclick: toggle,
      "aria-expanded": String(open), "aria-controls": `details-${row.index}`,
    }, el("span", { class: "arrow", "aria-hidden": "true" }),
    el("span", { class: "label" }, technique, settings && el("small", {}, settings))));
}

function numberCell(column, row, largest) {
  const value = column.value(row);
  const cell = el("td", {
    class: "number", "data-key": column.key, "data-value": isNumber(value) ? String(value) : "",
    title: isNumber(value) ? null : "not measured",
  }, column.text(value));
  if (column.bar && isNumber(value) && largest > 0) {
    const bar = el("i", { class: `bar ${column.bar}` });
    bar.style.setProperty("--share", value / largest);
    cell.append(bar);
  }
  return cell;
}

function bodyRows(row, columns, largest) {
  const open = state.expanded.has(row);
  const status = el("td", { class: "status" }, row.raw.status);
  const cells = row.available
    ? columns.slice(2).map((column) => numberCell(column, row, largest.get(column.key)))
    : el("td", { class: "reason", colspan: columns.length - 2 }, el("span", {}, row.raw.reason || "no reason given"));
  const name = row.available ? "row" : "row unavailable";
  const line = el("tr", { class: name, "data-row": row.index }, nameCell(row), status, cells);
  const details = open && el("tr", { class: "details-row", id: `details-${row.index}` },
    el("td", { colspan: columns.length }, detailsOf(row)));
  return [line, details];
}

function renderTable() {
  const columns = tableColumns();
  const sortColumn = columns.find((column) => column.key === state.sort.key) ?? columns[0];
  const largestOf = (column) => Math.max(0, ...state.group.rows.map(column.value).filter(isNumber));
  const largest = new Map(columns.map((column) => [column.key, largestOf(column)]));
  const rows = sortedRows(sortColumn).flatMap((row) => bodyRows(row, columns, largest)).filter(Boolean);
  byId("figures").replaceChildren(
    el("caption", { class: "offscreen" }, `Errors and costs, ${state.group.title.join(", ")}; ` +
      `false shadow, false light and RMSE against ${kinds[state.kind].label}`),
    tableHead(columns), el("tbody", {}, rows));
}

// From a chart: opens the row and brings it into view.
function showRow(row) {
  state.expanded.add(row);
  renderTable();
  byId(`open-${row.index}`).focus({ preventScroll: true });
  byId(`open-${row.index}`).scrollIntoView({ block: "center", behavior: "smooth" });
}
