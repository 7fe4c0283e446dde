// What a row opens to: command, passes, measuring, reference, settings.

async function copyText(text, button) {
  let copied = false;
  try {
    await navigator.clipboard.writeText(text);
    copied = true;
  } catch {
    // A page opened from disk may be refused the clipboard; the old way still works there.
    const area = el("textarea", { class: "offscreen", readonly: true });
    area.value = text;
    document.body.append(area);
    area.select();
    copied = document.execCommand("copy");
    area.remove();
  }
  button.textContent = copied ? "Copied" : "Select and copy by hand";
  setTimeout(() => { button.textContent = "Copy"; }, 2000);
}

function commandBlock(command) {
  const copy = () => copyText(command, button);
  const button = el("button", { type: "button", class: "copy", "aria-live": "polite", onclick: copy }, "Copy");
  // Words stay whole where a line ends: a break inside "--size" would read as a space.
  const words = command.split(/( +)/).map((word) => (word.trim() ? el("span", { class: "word" }, word) : word));
  return el("div", { class: "command" }, el("code", {}, words), button);
}

function passesTable(row) {
  const figures = ["median ms", "p95 ms", "MAD ms", "draws", "dispatches", "triangles"];
  const head = (text, isNumber) => el("th", { scope: "col", class: isNumber ? "number" : null }, text);
  const cells = (pass) => [formatMs(pass.median_ms), formatMs(pass.p95_ms), formatMs(pass.mad_ms),
    formatCount(pass.draws), formatCount(pass.dispatches), formatCount(pass.triangles)];
  return el("div", { class: "inner-scroller" }, el("table", { class: "passes" },
    el("thead", {}, el("tr", {}, head("pass"), head("stage"), figures.map((text) => head(text, true)))),
    el("tbody", {}, row.passes.map((pass) => el("tr", {},
      el("th", { scope: "row" }, pass.name),
      el("td", {}, el("i", { class: `dot ${stageNames.includes(pass.stage) ? pass.stage : ""}` }), pass.stage ?? dash),
      cells(pass).map((text) => el("td", { class: "number" }, text)))))));
}

function definitionList(entries) {
  const filled = entries.filter(([, text]) => text !== null && text !== undefined && text !== "");
  return filled.length === 0 ? null
    : el("dl", { class: "pairs" }, filled.map(([name, text]) => el("div", {}, el("dt", {}, name), el("dd", {}, text))));
}

// The passes must add up to the frame; where they do not, the times of this row are not to be trusted.
function sumText(timing) {
  const { frame_ms: frame, sum_of_passes_ms: sum } = timing;
  if (!isNumber(frame) || !isNumber(sum)) return null;
  const difference = frame > 0 ? (sum - frame) / frame : 0;
  const percent = `${difference < 0 ? "−" : "+"}${Math.abs(100 * difference).toFixed(1)}${narrowSpace}%`;
  const text = `${withUnit(formatMs(sum), "ms")} of ${withUnit(formatMs(frame), "ms")} (${percent})`;
  return Math.abs(difference) > 0.1 ? el("span", { class: "warning" }, `${text}: they disagree`) : text;
}

function timingList(timing = {}) {
  return definitionList([
    ["mode", timing.mode], ["clock", timing.clock],
    ["frames", isNumber(timing.frames) ? `${timing.frames}, after ${timing.warm_up ?? 0} for warm-up` : null],
    ["sum of passes / whole frame", sumText(timing)],
  ]);
}

function referenceList(reference = {}) {
  const rank = ([kind]) => Object.keys(kinds).indexOf(kind);
  const text = ({ kind, samples, confidence }) => [
    kind, isNumber(samples) ? plural(samples, "sample") : null,
    isNumber(confidence) && confidence > 0 ? `mae ± ${confidence.toPrecision(2)} (95 %)` : null,
  ].filter(Boolean).join(", ");
  return definitionList(Object.entries(reference ?? {}).filter(([, value]) => value && typeof value === "object")
    .sort((a, b) => rank(a) - rank(b)).map(([kind, value]) => [kinds[kind]?.label ?? kind, text(value)]));
}

function errorsTable(row) {
  const present = Object.keys(kinds).filter((kind) => row[kind]);
  if (present.length === 0) return null;
  const lines = [
    ["mean absolute error", (v) => formatError(v.mae)],
    ["RMS error", (v) => formatError(v.rmse)],
    ["bias", (v) => formatSigned(v.bias)],
    ["false shadow, area", (v) => withUnit(formatPercent(v.false_shadow?.area), "%")],
    ["false shadow, severity", (v) => formatShare(v.false_shadow?.severity)],
    ["false light, area", (v) => withUnit(formatPercent(v.false_light?.area), "%")],
    ["false light, severity", (v) => formatShare(v.false_light?.severity)],
    ["receivers", (v) => formatCount(v.receivers)],
  ];
  return el("table", { class: "errors" },
    el("thead", {}, el("tr", {}, el("td"), present.map((kind) => el("th", { scope: "col", class: "number" }, kind)))),
    el("tbody", {}, lines.map(([name, text]) => el("tr", {}, el("th", { scope: "row" }, name),
      present.map((kind) => el("td", { class: "number" }, text(row[kind])))))));
}

// Scores come as numbers; whatever else a line holds is shown as it is.
function artefactList(artefacts) {
  return definitionList(Object.entries(artefacts ?? {}).map(([name, score]) =>
    [name.replaceAll("_", " "), isNumber(score) ? formatError(score) : score === null ? dash : JSON.stringify(score)]));
}

function detailsOf(row) {
  const { raw } = row;
  const block = (title, content, shape) => content && el("section", { class: shape }, el("h3", {}, title), content);
  const settings = Object.entries(raw.settings ?? {});
  return el("div", { class: "details" },
    block("Command that repeats this row", commandBlock(raw.command), "wide"),
    !row.available && block("Why it is unavailable", el("p", {}, raw.reason || "no reason given"), "wide"),
    row.passes.length > 0 && block("Passes", passesTable(row), "wide"),
    block("Errors", errorsTable(row), "tall"),
    row.available && block("Measuring", timingList(raw.timing ?? {})),
    row.available && block("Reference", referenceList(raw.reference)),
    block("Artefact scores", artefactList(raw.artefacts)),
    settings.length > 0 && block("Settings in effect", el("ul", { class: "settings" },
      settings.map(([name, value]) => el("li", {}, el("span", {}, name), " ", el("b", {}, value)))), "wide"));
}
